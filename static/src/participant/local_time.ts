// Times of the page in the reader's own time zone.

import { language } from "../words";

/** Write every `<time data-local>` as the clock on the reader's wall will show it. */
export function showLocalTimes(root: ParentNode = document): void {
  const format = new Intl.DateTimeFormat(language(), { dateStyle: "long", timeStyle: "short" });
  for (const time of root.querySelectorAll<HTMLTimeElement>("time[data-local]")) {
    time.textContent = format.format(new Date(time.dateTime));
  }
}
