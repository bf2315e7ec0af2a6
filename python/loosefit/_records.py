"""Nested JSON as flat records, one per row of the CSV file of the same content."""
from __future__ import annotations

import math
import statistics
from collections.abc import Mapping
from typing import Any, Optional

_SITE_KEYS = frozenset({
    "panel", "u_m", "v_m", "position_m", "region", "angle_deg", "body_address", "covered",
    "why_not_covered", "footprint", "by_donning", "uncertainty"})


def _address_columns(address: Optional[Mapping[str, Any]]) -> dict[str, Any]:
    if address is None:
        return {"body_segment": None, "body_side": None, "body_x_percent": None,
                "body_y_percent": None, "body_z_percent": None}
    x, y, z = (round(percent, 1) for percent in address["percent"])
    return {"body_segment": address["segment"], "body_side": address["side"],
            "body_x_percent": x, "body_y_percent": y, "body_z_percent": z}


def _footprint_words(shape: Mapping[str, Any]) -> str:
    def millimetres(metres: float) -> str:
        return f"{round(1000 * metres, 1):g}"
    if "radius_m" in shape:
        return f"disc of {millimetres(2 * shape['radius_m'])} mm"
    if "size_m" in shape:
        across, along = shape["size_m"]
        return f"{millimetres(across)} x {millimetres(along)} mm"
    if "length_m" in shape:
        return f"line of {millimetres(shape['length_m'])} mm"
    return "girth"


def _with_uncertainty(site: Mapping[str, Any]) -> dict[str, Any]:
    """The site with uncertainty.<name>, the standard deviation of all that is known."""
    parts = site.get("uncertainty", {})  # not in outputs of earlier versions
    return dict(site) | {f"uncertainty.{name}": math.hypot(p["mesh"] or 0, p["donnings"] or 0)
                         for name, p in parts.items()}


def site_records(sites: Mapping[str, Any], uncovered: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Rows of sites.csv from `sites` and `uncovered_sites` of summary.json.

    Every row has the same keys; None where a site lacks a value.
    """
    sites = {name: _with_uncertainty(site) for name, site in sites.items()}
    names = sorted({key for site in sites.values() for key in site if key not in _SITE_KEYS})
    rows = []
    for name, site in sites.items():
        x, y, z = site["position_m"]
        row = {"name": name, "region": site["region"], "panel": site["panel"], "u_m": site["u_m"],
               "v_m": site["v_m"], "x_m": x, "y_m": y, "z_m": z,
               "angle_deg": round(site["angle_deg"], 8), **_address_columns(site["body_address"])}
        if "footprint" in site:  # not in outputs of earlier versions
            row["footprint"] = _footprint_words(site["footprint"])
        row.update({key: site.get(key) for key in names})
        row["covered"] = site["covered"]
        row["why_not_covered"] = site.get("why_not_covered", "")
        rows.append(row)
    columns = list(rows[0]) if rows else ["name", "covered", "why_not_covered"]
    for name, site in uncovered.items():
        if site["preset"]:
            continue  # presets that miss the garment are no news
        rows.append({**dict.fromkeys(columns), "name": name, "covered": False,
                     "why_not_covered": site["why"]})
    return rows


def _median(values: list[Optional[float]]) -> Optional[float]:
    known = [value for value in values if value is not None and math.isfinite(value)]
    return statistics.median(known) if known else None


def _ends(interval: Optional[list[float]]) -> tuple[Optional[float], Optional[float]]:
    return (None, None) if interval is None else (interval[0], interval[1])


def ranking_records(ranking: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Rows of ranking-NAME.csv from the content of ranking-NAME.json, best first."""
    metrics = sorted({metric for site in ranking["sites"] for metric in site["metrics"]})
    rows = []
    for site in ranking["sites"]:
        row = {key: site[key]
               for key in ("rank", "name", "score_robust", "score_median", "passing")}
        for name, interval in (("robust", "score_robust_interval"),
                               ("median", "score_median_interval"), ("rank", "rank_interval")):
            row[f"{name}_low"], row[f"{name}_high"] = _ends(site[interval])
        row["tied_with"] = "; ".join(site["tied_with"])
        for key in ("limiting_metric", "limiting_reason", "limiting_sample", "region", "panel",
                    "u_m", "v_m", "angle_deg"):
            row[key] = site[key]
        row["x_m"], row["y_m"], row["z_m"] = site["position_m"]
        row["to_seam_mm"], row["to_edge_mm"] = site["to_seam_mm"], site["to_edge_mm"]
        row.update(_address_columns(site["body_address"]))
        row["footprint"] = _footprint_words(site["footprint"])
        tolerance = site["tolerance"] or {}
        row["tolerance_along_mm"] = tolerance.get("along_mm")
        row["tolerance_around_mm"] = tolerance.get("around_mm")
        row.update({metric: _median(site["metrics"].get(metric, [])) for metric in metrics})
        rows.append(row)
    return rows
