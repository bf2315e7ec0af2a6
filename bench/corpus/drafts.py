"""The program's own drafts in several fits, as [garment] of a scenario, and some as DXF files that the program writes and reads back."""

# name → ([garment], fabric)
PAPER, KNIT = "paper-cotton", "compression-knit"
DRAFTS = {
    "draft_shirt": ('pattern = "long-sleeve-shirt"', PAPER),
    "draft_shirt_loose": ('pattern = "long-sleeve-shirt"\nfit = { chest = 0.28, hip = 0.22, sleeve = 0.45, wrist = 0.5, scye_ease = 0.04 }', PAPER),
    "draft_shirt_slim": ('pattern = "long-sleeve-shirt"\nfit = { chest = 0.06, waist = 0.08, hip = 0.06, sleeve = 0.18, wrist = 0.2 }', PAPER),
    "draft_shirt_bands": ('pattern = "long-sleeve-shirt"\nfit = { chest = 0.15, neckband_width = 0.02, cuff_width = 0.05, bust_dart = 0.6, elbow_bend = 15 }', PAPER),
    "draft_tee": ('pattern = "t-shirt"', PAPER),
    "draft_tee_loose": ('pattern = "t-shirt"\nfit = { chest = 0.3, hip = 0.25, sleeve = 0.5, wrist = 0.55 }', PAPER),
    "draft_tee_band": ('pattern = "t-shirt"\nfit = { chest = 0.15, neckband_width = 0.02, neckband_stretch = 0, edge_finish = 0.02 }', PAPER),
    "draft_tank": ('pattern = "tank-top"', PAPER),
    "draft_tank_loose": ('pattern = "tank-top"\nfit = { chest = 0.2, hip = 0.2, strap_width = 0.6 }', PAPER),
    "draft_hoodie": ('pattern = "hoodie"', PAPER),
    "draft_hoodie_loose": ('pattern = "hoodie"\nfit = { chest = 0.4, hip = 0.3, sleeve = 0.55 }', PAPER),
    "draft_trousers": ('pattern = "trousers"', PAPER),
    "draft_trousers_loose": ('pattern = "trousers"\nfit = { hip = 0.18, thigh = 0.3, knee = 0.5, hem = 1.2 }', PAPER),
    "draft_shorts": ('pattern = "trousers"\nfit = { hip = 0.12, leg_length = 0.3, hem = 0.35 }', PAPER),
    "draft_leggings": ('pattern = "leggings"', KNIT),
}
# name → [garment]
EXPORTS = {
    "dxf_own_shirt": 'pattern = "long-sleeve-shirt"',
    "dxf_own_tee": 'pattern = "t-shirt"\nfit = { chest = 0.15 }',
    "dxf_own_tank": 'pattern = "tank-top"\nfit = { chest = 0.1 }',
    "dxf_own_trousers": 'pattern = "trousers"\nfit = { hip = 0.12, waistband_width = 0 }',
}
# Bands that are cut shorter than what they are sewn to, and cloth cut narrower than the wearer.
STRETCHED = {"draft_hoodie", "draft_hoodie_loose", "draft_trousers", "draft_trousers_loose", "draft_shorts", "draft_leggings"}


def of_shirt():
    """The seams of a shirt as the program writes it: front and back from the hem on, sleeves in halves."""
    front = {"L": ("e2", "e3", "e4"), "R": ("e8", "e7", "e6")}  # side, armhole, shoulder
    back = {"R": ("e2", "e3", "e4"), "L": ("e8", "e7", "e6")}
    # Cap, underarm, top: one half of a pair begins with the cap, the other with the top.
    first, second = ("e1", "e2", "e4"), ("e4", "e3", "e1")
    halves = {"L": (first, second), "R": (second, first)}
    seams = []
    for s in "LR":
        f, b = halves[s]
        seams += [(f"side_{s}", f"front.{front[s][0]}", f"back.{back[s][0]}"), (f"shoulder_{s}", f"front.{front[s][2]}", f"back.{back[s][2]}"),
                  (f"armhole_front_{s}", f"front.{front[s][1]}", f"sleeve_{s}_front.{f[0]}"), (f"armhole_back_{s}", f"back.{back[s][1]}", f"sleeve_{s}_back.{b[0]}"),
                  (f"underarm_{s}", f"sleeve_{s}_front.{f[1]}", f"sleeve_{s}_back.{b[1]}"), (f"top_{s}", f"sleeve_{s}_front.{f[2]}", f"sleeve_{s}_back.{b[2]}")]
    return seams


# Seams of what is no known garment for the reader of DXF: it knows sleeves in one piece only.
SEAMS = {"dxf_own_shirt": of_shirt(), "dxf_own_tee": of_shirt()}
