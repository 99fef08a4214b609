// Two moving figures and a third, X, that equals one of them; which one?

import { t } from "../words";
import { LETTERS } from "./ab";
import { choosing } from "./choice";

export const abx = choosing<unknown>({
  unit: "the figure that X is taken for, 0 the left one",
  name: (place) => LETTERS[place] ?? "",
  count: () => 2,
  none: () => null,
  open: () => t("Is X equal to A or to B?"),
  chosen: (name) => t("You say: X is {name}.", { name }),
});
