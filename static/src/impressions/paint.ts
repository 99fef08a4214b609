// The content policy allows no style in markup: custom properties are set on the element.
import { nothing } from "lit";
import { Directive, directive, type ElementPart } from "lit/directive.js";

class Paint extends Directive {
  override render(_properties: Record<string, string | number>): typeof nothing {
    return nothing;
  }

  override update(part: ElementPart, [properties]: [Record<string, string | number>]): typeof nothing {
    const { style } = part.element as HTMLElement;
    for (const [name, value] of Object.entries(properties)) style.setProperty(name, String(value));
    return nothing;
  }
}

/** `<i ${paint({ "--at": 0.5 })}>` */
export const paint = directive(Paint);
