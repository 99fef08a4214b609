// Several moving figures in step; one is chosen.

import { t } from "../words";
import { choosing } from "./choice";

/** What a study sets. */
export interface Parameters {
  allow_none: boolean;
}

export const choose = choosing<Parameters>({
  unit: "the chosen figure, counted from 0 as they stand on the page; −1 for none of them",
  name: (place) => String(place + 1),
  count: ({ step }) => step.figures.length,
  none: ({ allow_none }) => (allow_none ? t("None of them") : null),
  open: () => t("Choose one"),
  chosen: (name) => t("You chose number {name}.", { name }),
});
