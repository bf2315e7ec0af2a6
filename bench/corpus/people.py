"""People of the corpus: the [body] section of their scenarios."""

PEOPLE = {
    "woman": 'sex = "female"\nage = 30\nheight = 1.68\nmeasurements = { chest = 0.96, waist = 0.80, hip = 1.02 }',
    "man": 'sex = "male"\nage = 35\nheight = 1.78\nmeasurements = { chest = 1.00, waist = 0.88, hip = 1.02 }',
    "slim": 'sex = "female"\nage = 25\nheight = 1.74\nmeasurements = { chest = 0.82, waist = 0.64, hip = 0.90 }',
    "heavy": 'sex = "male"\nage = 50\nheight = 1.76\nmeasurements = { chest = 1.16, waist = 1.10, hip = 1.14 }',
    "girl": 'sex = "female"\nage = 11\nheight = 1.45\nmeasurements = { chest = 0.72, waist = 0.62, hip = 0.76 }',
    "old": 'sex = "female"\nage = 70\nheight = 1.60\nmeasurements = { chest = 1.04, waist = 0.94, hip = 1.08 }',
}
