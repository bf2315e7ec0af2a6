// The two views, their controls, and what connects them: one map, one drape, one probed point.
import type { DataTexture } from "three";
import type { Case, Place, RankedPlace, State } from "./case_data";
import { makeScale, tickText, type RangeChoice, type Scale } from "./colour_scale";
import { Controls } from "./controls";
import { save, saveText, valuesCsv } from "./downloads";
import { make } from "./elements";
import { listenToPattern, listenToWorn } from "./gestures";
import { Legend, titleText } from "./legend";
import { MapAttributes, tableTexture } from "./map_material";
import { makeLineMarks } from "./lines";
import type { Ink, Mark } from "./marks";
import { PatternView } from "./pattern_view";
import { makePicture } from "./picture";
import { readPoint, type Reading } from "./probe";
import type { SurfacePoint } from "./picking";
import { WornView, type View } from "./worn_view";

const kPlaceRows = "tr[data-site], tr[data-place], tr[data-line]";
const kViews: [View, string][] = [["front", "Front"], ["back", "Back"], ["left", "Left"], ["right", "Right"]];

export class Viewer {
  private readonly worn: WornView;
  private readonly pattern: PatternView;
  private readonly attributes: MapAttributes;
  private readonly legend: Legend;
  private readonly textures = new Map<Uint8Array, DataTexture>();
  private readonly controls: Controls;
  private readonly readout: Record<string, HTMLElement> = {};
  private readonly live: HTMLElement;
  private readonly legendTitle: HTMLAnchorElement;
  private state: State;
  private stateIndex = 0;
  private array: string | null;
  private wished: string | null; // the map to come back to
  private scale: Scale | null = null;
  private pinned: SurfacePoint | null = null;
  private hovered: SurfacePoint | null = null;
  private readonly siteMarks: Mark[] = [];
  private readonly placeMarks: Mark[] = [];

  constructor(private readonly host: HTMLElement, private readonly data: Case) {
    this.state = data.state(0);
    this.array = this.wished = this.firstMap();
    const canvas = (label: string) => make("canvas", { tabindex: "0", role: "application", "aria-label": label });
    const wornCanvas = canvas("The garment as worn, in 3-D. Arrow keys turn, plus and minus zoom, F, B, L, R " +
      "show front, back, left and right, Enter reads the middle of the picture.");
    const flatCanvas = canvas("The flat pattern. Arrow keys move the probe, plus and minus zoom, 0 shows all.");
    const wornOver = make("canvas", { class: "over", "aria-hidden": "true" });
    const flatOver = make("canvas", { class: "over", "aria-hidden": "true" });
    const views = make("div", { class: "views", role: "group", "aria-label": "Look from" });
    const wornPane = make("div", { class: "pane worn" }, wornCanvas, wornOver, views,
      make("p", { class: "hint" }, "Drag to turn · pinch or Ctrl + wheel to zoom · click to pin a point"));
    const flatPane = make("div", { class: "pane flat" }, flatCanvas, flatOver);
    if (data.ranking)
      flatPane.append(make("p", { class: "hint" }, "● passes · ■ does not pass · dashed: tolerance · shaded: too near an edge or seam"));
    const legendCanvas = make("canvas", { class: "bar", role: "img" });
    this.legendTitle = make("a", { class: "def", href: "#" });
    this.live = make("p", { class: "sr", role: "status", "aria-live": "polite" });
    this.controls = new Controls(data, this.state, this.array, {
      chooseMap: (array) => this.chooseMap(array),
      showMap: () => this.showMap(),
      chooseState: (posture, donning) => {
        const wanted = data.find(posture, donning);
        this.chooseState(wanted >= 0 ? wanted : this.stateIndex);
      },
      showLook: () => this.showLook(),
      save: (what) => this.save(what),
    });
    host.replaceChildren(this.controls.element, make("div", { class: "panes" }, wornPane, flatPane),
      make("div", { class: "foot" },
        make("div", { class: "legend" }, make("div", { class: "title" }, this.legendTitle), legendCanvas),
        this.makeReadout()), this.live);
    this.attributes = new MapAttributes(data);
    this.attributes.setState(this.state);
    const ink = () => this.ink();
    this.worn = new WornView(data, wornCanvas, wornOver, this.attributes, ink);
    const view = kViews.find(([name]) => name === host.dataset.view);
    if (view) this.worn.look(view[0], false); // the side of the first answer
    this.pattern = new PatternView(data, flatCanvas, flatOver, this.attributes, ink);
    this.legend = new Legend(legendCanvas);
    for (const [view, words] of kViews) {
      const button = make("button", { type: "button", "data-view": view }, words);
      button.addEventListener("click", () => this.worn.look(view));
      views.append(button);
    }
    this.makeMarks();
    const gestures = {
      hover: (point: SurfacePoint | null) => this.hover(point),
      pin: (point: SurfacePoint | null) => this.pin(point),
      step: (du: number, dv: number) => this.step(du, dv),
      flyToPinned: () => { if (this.pinned) this.worn.flyTo(this.pinned); },
    };
    listenToWorn(wornCanvas, this.worn, gestures);
    listenToPattern(flatCanvas, this.pattern, gestures);
    this.linkTables();
    new ResizeObserver(() => {
      this.worn.resize();
      this.pattern.resize();
      this.drawLegend();
    }).observe(host);
    window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
      this.worn.draw();
      this.pattern.draw();
      this.drawLegend();
    });
    this.worn.resize();
    this.pattern.resize();
    this.showMap();
    this.worn.render();
    this.pattern.render();
  }

  private firstMap(): string | null {
    const has = (a: string) => this.state.maps.has(a);
    return [this.host.dataset.map ?? "", "distance_mm"].find(has) ?? this.data.order.find(has) ?? null;
  }

  private ink(): Ink {
    const style = getComputedStyle(document.documentElement);
    const of = (name: string) => style.getPropertyValue(name).trim();
    return { text: of("--ink"), paper: of("--paper"), soft: of("--soft"), accent: of("--probe"),
             dark: window.matchMedia("(prefers-color-scheme: dark)").matches };
  }

  private makeReadout(): HTMLElement {
    const list = make("dl", { class: "readout" });
    for (const [key, words] of [["value", "Value"], ["place", "Pattern"], ["address", "Body"],
                                ["skin", "Skin"]]) {
      this.readout[key] = make("dd", { "data-probe": key }, "–");
      list.append(make("div", { class: key }, make("dt", {}, words), this.readout[key]));
    }
    const clear = make("button", { type: "button", class: "plain", id: "unpin", disabled: "" }, "Unpin");
    clear.addEventListener("click", () => {
      this.choose(null);
      this.pin(null);
    });
    this.readout.unpin = clear;
    return make("div", { class: "probe" }, list, clear);
  }

  // ------------------------------------------------------------------------------- state and map

  chooseMap(array: string | null): void {
    this.wished = array;
    this.array = array !== null && this.state.maps.has(array) ? array : null;
    this.controls.map.value = this.array ?? "";
    if (this.controls.range.value === "own") this.controls.range.value = "fit";
    this.showMap();
  }

  chooseState(index: number): void {
    this.stateIndex = index;
    this.state = this.data.state(index);
    this.controls.posture.value = String(this.state.posture);
    this.controls.donning.value = String(this.state.donning);
    const has = (a: string | null) => a !== null && this.state.maps.has(a);
    // A posture has its slip where the reference has the maps.
    this.array = has(this.wished) ? this.wished
      : this.wished === null ? null : this.data.order.find((a) => has(a)) ?? null;
    for (const option of this.controls.map.options)
      option.disabled = option.value !== "" && !this.state.maps.has(option.value);
    this.controls.map.value = this.array ?? "";
    this.attributes.setState(this.state);
    this.worn.setState(this.state);
    this.showMap();
  }

  private showMap(): void {
    const style = this.array ? this.data.maps.get(this.array)! : null;
    const values = this.array ? this.state.maps.get(this.array) : undefined;
    const { range, low, high } = this.controls;
    for (const control of [range, low, high]) control.disabled = !style;
    if (style) {
      const unit = style.percent ? 100 : 1;
      const own: [number, number] = [Number(low.value) / unit, Number(high.value) / unit];
      this.scale = makeScale(this.data, style, values, range.value as RangeChoice, own);
      if (range.value !== "own") {
        low.value = tickText(this.scale.low, style).replace("\u2212", "-");
        high.value = tickText(this.scale.high, style).replace("\u2212", "-");
      }
      this.legendTitle.textContent = titleText(style, values);
      this.legendTitle.setAttribute("href", `#def-${this.array}`);
    } else {
      this.scale = null;
      low.value = high.value = "";
      this.legendTitle.textContent = this.state.holds ? "Plain cloth" : "Plain cloth: this drape is not settled and worn";
      this.legendTitle.removeAttribute("href");
    }
    this.attributes.setMap(values?.values ?? null, this.scale);
    this.showLook();
    this.showReading();
  }

  private texture(): DataTexture | null {
    if (!this.scale) return null;
    let texture = this.textures.get(this.scale.table);
    if (!texture) this.textures.set(this.scale.table, texture = tableTexture(this.scale.table));
    return texture;
  }

  private showLook(): void {
    const mapped = this.scale !== null;
    const contours = mapped && this.controls.checked("contours") ? this.scale!.lines : 0;
    const texture = this.texture();
    this.worn.showArrows = this.controls.checked("arrows");
    this.worn.showPlaces = this.pattern.showPlaces = this.controls.checked("places");
    const middle = this.scale?.middle ?? true;
    const contact = this.controls.checked("contact");
    this.worn.setLook(mapped, texture, contours, middle, contact, this.controls.share("cloth"),
                      this.controls.share("body"));
    this.pattern.setLook(mapped, texture, contours, middle, contact);
    this.drawLegend();
  }

  private drawLegend(): void {
    const style = this.array ? this.data.maps.get(this.array)! : null;
    if (!style || !this.scale) {
      this.legend.clear();
      return;
    }
    const point = this.hovered ?? this.pinned;
    const needle = point ? this.read(point).value : null;
    this.legend.draw(this.scale, style, this.state.maps.get(this.array!), this.ink().text, needle);
  }

  // ------------------------------------------------------------------------------- probing

  read(point: SurfacePoint): Reading {
    return readPoint(this.data, this.state, this.stateIndex === 0, this.array, point);
  }

  hover(point: SurfacePoint | null): void {
    this.hovered = point;
    this.showReading();
  }

  /** `announce`: for a screen reader. */
  pin(point: SurfacePoint | null, announce = true): void {
    this.pinned = point;
    this.hovered = null;
    (this.readout.unpin as HTMLButtonElement).disabled = point === null;
    const reading = this.showReading();
    if (announce)
      this.live.textContent = reading
        ? `${this.legendTitle.textContent}: ${reading.text}; ${this.readout.place.textContent}; ${this.readout.address.textContent}`
        : "No point";
  }

  private showReading(): Reading | null {
    const point = this.hovered ?? this.pinned;
    const reading = point ? this.read(point) : null;
    this.worn.setProbe(point, reading?.skin ?? null);
    this.pattern.setProbe(point);
    const set = (key: string, text: string) => { this.readout[key].textContent = text || "–"; };
    if (!reading) {
      for (const key of ["value", "place", "address", "skin"]) set(key, "");
    } else {
      set("value", this.array ? reading.text : "");
      const mm = (x: number) => (1000 * x).toFixed(1).replace("-", "\u2212");
      set("place", `${reading.panel} · u ${mm(reading.u)}, v ${mm(reading.v)} mm`);
      set("address", [reading.address, reading.region].filter((t) => t).join(" · "));
      const touches = reading.touches === null ? "" : reading.touches ? "touches" : "stands off";
      const skin = reading.gap === null ? "" : `${(1000 * reading.gap).toFixed(1)} mm to its partner`;
      set("skin", [touches, skin].filter((t) => t).join(" · "));
    }
    this.drawLegend();
    return reading;
  }

  /** Moves the pinned point in the flat pattern; there is one in the first piece to begin with. */
  private step(du: number, dv: number): void {
    if (!this.pinned) {
      this.pin({ triangle: 0, weights: [1 / 3, 1 / 3, 1 / 3] });
      return;
    }
    const { panel, u, v } = this.pattern.placeOf(this.pinned);
    const next = this.pattern.find(panel, u + du, v + dv);
    if (next) this.pin(next);
  }

  /** Probes a place of the pattern [m]; for tests. */
  probePattern(panel: string, u: number, v: number): Reading | null {
    const index = this.data.panels.findIndex((p) => p.id === panel);
    const point = index < 0 ? null : this.pattern.find(index, u, v, true);
    if (!point) return null;
    this.pin(point);
    return this.read(point);
  }

  /** Where a place of the pattern is seen in either view, in CSS pixels; for tests. */
  whereOnScreen(panel: string, u: number, v: number): { worn: [number, number]; flat: [number, number] } | null {
    const index = this.data.panels.findIndex((p) => p.id === panel);
    const point = index < 0 ? null : this.pattern.find(index, u, v, true);
    return point && { worn: this.worn.project(this.worn.positionOf(point)), flat: this.pattern.screenOf(point) };
  }

  /** Milliseconds of one pick and reading at a place of the 3-D view; for the bench. */
  timeProbe(x: number, y: number): number {
    const begun = performance.now();
    this.hover(this.worn.pick(x, y));
    return performance.now() - begun;
  }
  timeFrame(): number {
    const begun = performance.now();
    this.worn.turn(0.01, 0);
    this.worn.render();
    this.worn.renderer.getContext().finish();
    return performance.now() - begun;
  }

  // ------------------------------------------------------------------------------- places

  private makeMarks(): void {
    const add = (list: Mark[], place: Place, ranked: RankedPlace | null) => {
      const point = this.pattern.findPlace(place);
      if (!point) return;
      list.push({ point, name: place.name, label: ranked ? String(ranked.mark) : "–",
                  passes: ranked ? ranked.passes : null, chosen: false, near: false });
    };
    for (const site of this.data.sites) add(this.siteMarks, site, null);
    for (const place of this.data.ranking?.places ?? []) add(this.placeMarks, place, place);
    this.worn.lines = this.pattern.lines = makeLineMarks(this.data.lines);
    this.showMarks();
  }

  private showMarks(): void {
    // Ranked places stand for their sites; the best is drawn last, on top.
    const ranked = new Set(this.placeMarks.map((m) => m.name));
    const marks = [...this.siteMarks.filter((m) => !ranked.has(m.name)), ...[...this.placeMarks].reverse()];
    this.worn.setMarks(marks);
    this.pattern.setMarks(marks);
  }

  /** Marks one site or place in views and tables; null: none. */
  choose(name: string | null): void {
    for (const mark of [...this.siteMarks, ...this.placeMarks, ...this.worn.lines])
      mark.chosen = mark.name === name;
    this.showMarks();
    for (const row of document.querySelectorAll<HTMLElement>(kPlaceRows))
      row.classList.toggle("chosen", name !== null &&
        (row.dataset.site ?? row.dataset.place ?? row.dataset.line) === name);
  }

  goTo(kind: "site" | "place" | "line", name: string): void {
    const point = kind === "line" ? this.middleOf(name)
      : (kind === "site" ? this.siteMarks : this.placeMarks).find((m) => m.name === name)?.point;
    if (!point) return;
    this.choose(name);
    this.pin(point);
    this.worn.flyTo(point);
    const host = document.getElementById("viewer")!, box = host.getBoundingClientRect();
    if (box.top < 0 || box.top > window.innerHeight * 0.5) {
      const calm = window.matchMedia("(prefers-reduced-motion: reduce)").matches;
      host.scrollIntoView({ behavior: calm ? "auto" : "smooth", block: "start" });
    }
  }

  private middleOf(line: string): SurfacePoint | undefined {
    const pieces = this.worn.lines.find((l) => l.name === line)?.pieces;
    return pieces?.[pieces.length >> 1].middle;
  }

  private linkTables(): void {
    for (const row of document.querySelectorAll<HTMLTableRowElement>(kPlaceRows)) {
      const kind = row.dataset.site !== undefined ? "site" : row.dataset.place !== undefined ? "place" : "line";
      const name = row.dataset[kind]!, head = row.cells[0];
      const button = make("button", { type: "button", class: "fly", title: "Show it on the garment" });
      button.append(...head.childNodes);
      head.replaceChildren(button);
      button.addEventListener("click", () => this.goTo(kind, name));
    }
  }

  // ------------------------------------------------------------------------------- pictures

  private fileName(): string {
    const parts = [this.data.json.scene.garment.name, this.state.name, this.array ?? "plain"];
    if (this.data.donnings > 1) parts.splice(2, 0, String(this.state.donning + 1));
    return parts.join("-").replace(/[^A-Za-z0-9]+/g, "-").replace(/^-|-$/g, "");
  }

  picture(which: "worn" | "flat"): HTMLCanvasElement {
    const map = this.scale && this.array ? { scale: this.scale, style: this.data.maps.get(this.array)!,
                                             values: this.state.maps.get(this.array) } : null;
    return makePicture(which === "worn" ? this.worn : this.pattern, map, this.ink());
  }

  private save(what: "worn" | "flat" | "values"): void {
    if (what === "values") {
      saveText(`${this.fileName()}.csv`, valuesCsv(this.data, this.state));
      return;
    }
    this.picture(what).toBlob((blob) => {
      if (blob) save(`${this.fileName()}${what === "flat" ? "-pattern" : ""}.png`, blob);
    }, "image/png");
  }
}
