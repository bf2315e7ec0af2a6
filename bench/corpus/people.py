"""People of the corpus: the [body] section of their scenarios, and what garments made for them are cut to (centimetres)."""


def person(sex, age, height, chest, waist, hip):
    return {"body": f'sex = "{sex}"\nage = {age}\nheight = {height}\n'
                    f"measurements = {{ chest = {chest}, waist = {waist}, hip = {hip} }}",
            "make": {"bust": 100 * chest, "waist": 100 * waist, "hip": 100 * hip, "height": 100 * height}}


PEOPLE = {
    "woman": person("female", 30, 1.68, 0.96, 0.80, 1.02),
    "man": person("male", 35, 1.78, 1.00, 0.88, 1.02),
    "slim": person("female", 25, 1.74, 0.82, 0.64, 0.90),
    "heavy": person("male", 50, 1.76, 1.16, 1.10, 1.14),
    "girl": person("female", 11, 1.45, 0.72, 0.62, 0.76),
    "old": person("female", 70, 1.60, 1.04, 0.94, 1.08),
}
