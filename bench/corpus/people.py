"""People of the corpus: the [body] section of their scenarios, and the tape measures that garments made for them are cut to (centimetres).

The tape measures are those that `loosefit body` (0.3.0) tells of these bodies, as a tailor would take them: `trunk` from the high point
of the shoulder down to the waist, `scye` to the armpit, `slope` of the shoulder as a rise over its run, `arm` from the shoulder point to
the wrist, `rise` from the crotch up to the waist, `drop` from the waist down to the hip."""


def person(sex, age, height, chest, waist, hip, **tape):
    return {"body": f'sex = "{sex}"\nage = {age}\nheight = {height}\n'
                    f"measurements = {{ chest = {chest}, waist = {waist}, hip = {hip} }}",
            "make": {"bust": 100 * chest, "waist": 100 * waist, "hip": 100 * hip, "height": 100 * height} | tape}


PEOPLE = {
    "woman": person("female", 30, 1.68, 0.96, 0.80, 1.02, neck=36.6, neck_w=11.0, shoulder_w=36.3, slope=.44, trunk=45.0, scye=21.5, arm=49.3,
                    elbow_at=27.2, biceps=29.8, elbow=22.5, forearm=22.5, wrist=13.1, rise=23.9, drop=17.6, thigh=56.2),
    "man": person("male", 35, 1.78, 1.00, 0.88, 1.02, neck=47.4, neck_w=14.8, shoulder_w=39.4, slope=.37, trunk=47.0, scye=23.0, arm=56.0,
                  elbow_at=30.5, biceps=34.0, elbow=26.2, forearm=24.3, wrist=16.8, rise=23.4, drop=17.4, thigh=56.8),
    "slim": person("female", 25, 1.74, 0.82, 0.64, 0.90, neck=36.3, neck_w=11.3, shoulder_w=37.0, slope=.48, trunk=45.5, scye=20.0, arm=50.5,
                   elbow_at=27.9, biceps=24.2, elbow=22.7, forearm=20.9, wrist=13.3, rise=24.1, drop=17.6, thigh=46.6),
    "heavy": person("male", 50, 1.76, 1.16, 1.10, 1.14, neck=48.2, neck_w=14.8, shoulder_w=39.8, slope=.27, trunk=48.5, scye=25.5, arm=54.8,
                    elbow_at=30.6, biceps=35.5, elbow=26.5, forearm=22.4, wrist=19.6, rise=23.6, drop=16.9, thigh=59.8),
    "girl": person("female", 11, 1.45, 0.72, 0.62, 0.76, neck=35.4, neck_w=10.8, shoulder_w=30.3, slope=.44, trunk=38.5, scye=17.0, arm=43.2,
                   elbow_at=23.2, biceps=22.0, elbow=19.0, forearm=18.7, wrist=11.4, rise=19.5, drop=13.8, thigh=41.8),
    "old": person("female", 70, 1.60, 1.04, 0.94, 1.08, neck=41.0, neck_w=12.7, shoulder_w=34.6, slope=.43, trunk=45.0, scye=23.5, arm=47.7,
                  elbow_at=26.6, biceps=29.9, elbow=22.9, forearm=21.1, wrist=16.8, rise=22.9, drop=17.6, thigh=56.9),
}
