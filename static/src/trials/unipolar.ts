// One moving figure, several qualities from not at all to very.

import { ofItems } from "./items";

export const unipolar = ofItems(0, "amount", "item id to step, 0 the lowest");
