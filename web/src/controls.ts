// The rows of controls above the views: which map, range, drape and look, and what can be saved.
import type { Case, State } from "./case_data";
import { make } from "./elements";

/** What follows when somebody touches a control. */
export interface ControlActions {
  chooseMap(array: string | null): void;
  showMap(): void;
  chooseState(posture: number, donning: number): void;
  showLook(): void;
  save(what: "worn" | "flat" | "values"): void;
}

const kOrdinals = ["1st", "2nd", "3rd"];

export class Controls {
  readonly element: HTMLElement;
  readonly map = make("select", { id: "map" });
  readonly range = make("select", { id: "range" },
    make("option", { value: "fit" }, "Round"), make("option", { value: "fixed" }, "Fixed"),
    make("option", { value: "drape" }, "All values"),
    make("option", { value: "own" }, "My own"));
  readonly low = make("input", { id: "low", type: "number", step: "any", "aria-label": "Range from" });
  readonly high = make("input", { id: "high", type: "number", step: "any", "aria-label": "Range to" });
  readonly posture = make("select", { id: "posture" });
  readonly donning = make("select", { id: "donning" });
  private readonly looks = new Map<string, HTMLInputElement>(); // check boxes and sliders

  constructor(data: Case, state: State, array: string | null, private readonly act: ControlActions) {
    this.fill(data, array);
    this.listen();
    const first = make("div", { class: "row" }, this.labelled("Map", this.map),
      make("div", { class: "group" }, this.labelled("Range", this.range), this.low,
        make("span", { class: "dash" }, "to"), this.high));
    if (data.postures.length > 1) first.append(this.labelled("Posture", this.posture));
    if (data.donnings > 1) first.append(this.labelled("Put on", this.donning));
    const second = make("div", { class: "row" }, this.slider("cloth", "Cloth"), this.slider("body", "Body"),
      this.check("contours", "Contours", false));
    if (state.touching) second.append(this.check("contact", "Contact", false));
    if (data.sites.length || data.lines.length || data.ranking)
      second.append(this.check("places", data.ranking ? "Places" : data.sites.length ? "Sites" : "Lines", true));
    if (data.postures.length > 1) second.append(this.check("arrows", "Slip arrows", true));
    second.append(this.files());
    this.element = make("div", { class: "controls", role: "group", "aria-label": "What is shown" }, first, second);
  }

  checked(id: string): boolean {
    return this.looks.get(id)?.checked ?? false;
  }
  /** Of a slider, 0 to 1. */
  share(id: string): number {
    return Number(this.looks.get(id)?.value ?? NaN) / 100;
  }

  private fill(data: Case, array: string | null): void {
    for (const name of data.order) this.map.append(make("option", { value: name }, data.maps.get(name)!.title));
    this.map.append(make("option", { value: "" }, "Plain cloth"));
    this.map.value = array ?? "";
    this.range.title = "Round: holds 96 % of the cloth in every drape of this page. " +
      "Fixed: the same in every report, so that garments can be compared. All values: least to greatest";
    data.postures.forEach((name, i) => this.posture.append(make("option", { value: String(i) }, name)));
    for (let k = 0; k < data.donnings; ++k)
      this.donning.append(make("option", { value: String(k) }, `${kOrdinals[k] ?? `${k + 1}th`} time`));
  }

  private listen(): void {
    this.map.addEventListener("change", () => this.act.chooseMap(this.map.value || null));
    this.range.addEventListener("change", () => this.act.showMap());
    for (const end of [this.low, this.high])
      end.addEventListener("change", () => {
        this.range.value = "own";
        this.act.showMap();
      });
    for (const control of [this.posture, this.donning])
      control.addEventListener("change", () =>
        this.act.chooseState(Number(this.posture.value), Number(this.donning.value)));
  }

  private labelled(words: string, control: HTMLElement, extra = ""): HTMLElement {
    return make("label", extra ? { class: extra } : {}, make("span", {}, words), control);
  }

  private check(id: string, words: string, on: boolean): HTMLElement {
    const box = make("input", { id, type: "checkbox" });
    box.checked = on;
    this.looks.set(id, box);
    box.addEventListener("change", () => this.act.showLook());
    return make("label", { class: "check" }, box, words);
  }

  private slider(id: string, words: string): HTMLElement {
    const bar = make("input", { id, type: "range", min: "0", max: "100", value: "100" });
    this.looks.set(id, bar);
    bar.addEventListener("input", () => this.act.showLook());
    return this.labelled(words, bar, "slider");
  }

  private files(): HTMLElement {
    const files = make("div", { class: "group end" }, make("span", { class: "soft" }, "Save"));
    for (const [id, words, what] of [["png-worn", "3-D", "worn"], ["png-flat", "Pattern", "flat"],
                                     ["csv", "Values (CSV)", "values"]] as const) {
      const button = make("button", { type: "button", id, class: "plain" }, words);
      button.title = what === "values" ? "All maps of this drape, one row per vertex" : "Save this view as PNG";
      button.addEventListener("click", () => this.act.save(what));
      files.append(button);
    }
    return files;
  }
}
