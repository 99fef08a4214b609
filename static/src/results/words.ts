// Numbers as a person reads them: true minus signs, no needless zeros. No DOM in here.

/** `−1.36`; a missing number is a dash. */
export function number(value: number | null, digits = 2, signed = false): string {
  if (value === null) return "–";
  const rounded = Number(value.toFixed(digits)) + 0;
  const sign = rounded < 0 ? "−" : signed && rounded > 0 ? "+" : "";
  return sign + Math.abs(rounded).toFixed(digits);
}

/** `−1.73 to −0.99`, or a dash where there is no interval. */
export const interval = (low: number | null, high: number | null): string =>
  low === null || high === null ? "–" : `${number(low)} to ${number(high)}`;

export const percent = (share: number): string => `${Math.round(share * 100)} %`;
