// Two moving figures in step; one is chosen, or no difference where that is allowed.

import { t } from "../words";
import { choosing } from "./choice";

/** What a study sets. */
export interface Parameters {
  allow_same: boolean;
}

export const LETTERS = ["A", "B", "X"] as const;

export const ab = choosing<Parameters>({
  unit: "the chosen figure, 0 the left one; −1 for no difference",
  name: (place) => LETTERS[place] ?? "",
  count: () => 2,
  none: ({ allow_same }) => (allow_same ? t("I see no difference") : null),
  open: () => t("Choose one"),
  chosen: (name) => t("You chose {name}.", { name }),
});
