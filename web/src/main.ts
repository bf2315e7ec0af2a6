import { readCase, type Case, type CaseJson } from "./case_data";
import { Viewer } from "./viewer";
import { showDefinitions } from "./definitions";
import { makeSortable, tableCsv } from "./tables";
import { saveText } from "./downloads";
import "./page.css";

/** Tables work without WebGL, too. */
function enhanceTables(): void {
  for (const table of document.querySelectorAll<HTMLTableElement>("table.sortable")) {
    makeSortable(table);
    const name = table.dataset.name;
    if (!name) continue;
    const button = document.createElement("button");
    button.type = "button";
    button.className = "plain";
    button.textContent = "Download CSV";
    button.dataset.csv = name;
    button.addEventListener("click", () => saveText(`${name}.csv`, tableCsv(table)));
    table.parentElement!.before(button);
  }
}

async function start(): Promise<void> {
  enhanceTables();
  showDefinitions();
  const root = document.documentElement;
  const host = document.getElementById("viewer"), json = document.getElementById("case");
  const arrays = document.getElementById("arrays");
  if (!root.classList.contains("webgl") || !host || !json || !arrays) {
    root.dataset.ready = "tables";
    return;
  }
  try {
    const data: Case = await readCase(JSON.parse(json.textContent!) as CaseJson, arrays.textContent!);
    const viewer = new Viewer(host, data);
    (window as unknown as { loosefit: unknown }).loosefit = viewer; // for tests and the curious
    root.dataset.ready = "viewer";
  } catch (error) {
    // The pictures say the same; the reason is told where the view would be.
    root.classList.remove("webgl");
    document.querySelector<HTMLDetailsElement>("details.stills")?.setAttribute("open", "");
    const note = document.createElement("p");
    note.className = "box warn";
    note.textContent = `The 3-D view could not start (${error instanceof Error ? error.message : error}); ` +
      "the pictures below show the same maps.";
    host.before(note);
    root.dataset.ready = "pictures";
  }
}

void start();
