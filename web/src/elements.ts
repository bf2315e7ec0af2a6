// DOM elements in one expression.
export function make<K extends keyof HTMLElementTagNameMap>(tag: K, attributes: Record<string, string> = {},
                                                            ...children: (Node | string)[]): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}
