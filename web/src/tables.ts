// Tables of the report that can be sorted, and whose rows lead to places on the garment.
import { csvCell } from "./downloads";

/** The number in a cell, or NaN: "≤ 0.12", "1 234", "+8.3 %", "2=". */
export function cellNumber(text: string): number {
  const plain = text.replace(/\u2212/g, "-").replace(/[\u00a0\s]/g, "");
  const found = plain.match(/^[≤≥+]*(-?\d+(?:\.\d+)?)/);
  return found ? Number(found[1]) : NaN;
}

export function makeSortable(table: HTMLTableElement): void {
  const heads = [...table.tHead!.rows[0].cells];
  const body = table.tBodies[0];
  const original = [...body.rows];
  heads.forEach((head, column) => {
    const button = document.createElement("button");
    button.type = "button";
    button.className = "sort";
    button.title = "Sort by this column";
    const words = head.textContent ?? "";
    button.setAttribute("aria-label", `Sort by ${words}`);
    button.innerHTML = "<span aria-hidden=\"true\"></span>";
    head.append(button);
    button.addEventListener("click", () => {
      const now = head.getAttribute("aria-sort");
      const next = now === "ascending" ? "descending" : now === "descending" ? null : "ascending";
      for (const other of heads) other.removeAttribute("aria-sort");
      let rows = [...original];
      if (next) {
        head.setAttribute("aria-sort", next);
        const sign = next === "ascending" ? 1 : -1;
        const key = new Map(rows.map((row) => {
          const text = row.cells[column]?.textContent?.trim() ?? "";
          return [row, { text, value: cellNumber(text) }] as const;
        }));
        rows.sort((a, b) => {
          const x = key.get(a)!, y = key.get(b)!;
          const nx = Number.isNaN(x.value), ny = Number.isNaN(y.value);
          if (!nx && !ny) return sign * (x.value - y.value);
          if (nx !== ny) return nx ? 1 : -1; // what has no value comes last
          return sign * x.text.localeCompare(y.text, "en", { numeric: true });
        });
      }
      body.append(...rows);
    });
  });
}

/** The cells of a table as RFC 4180 text. */
export function tableCsv(table: HTMLTableElement): string {
  const cell = (text: string) => csvCell(text.replace(/\u2212/g, "-").trim());
  const words = (c: HTMLTableCellElement) => {
    const copy = c.cloneNode(true) as HTMLElement;
    copy.querySelectorAll(".sort").forEach((b) => b.remove());
    return copy.textContent ?? "";
  };
  return [...table.rows].map((row) => [...row.cells].map((c) => cell(words(c))).join(",")).join("\r\n") + "\r\n";
}
