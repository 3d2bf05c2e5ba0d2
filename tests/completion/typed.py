"""What is typed before Tab is pressed, and what the tool must be given then, in every shell."""
import names


class InEveryShell:
    """Tests of classes whose `check(line, *words)` compares what the line has become with words."""

    def test_names_come_out_as_they_are(self):
        for face in names.FACES:
            if face == "new\nline":
                continue
            plain = "".join("\\" + c if not c.isalnum() else c for c in face[:3])
            self.check(f"refine mesh.json --face-area {plain}", "refine", "mesh.json", "--face-area", face + "=")
            self.check(f"refine mesh.json --face-area={plain}", "refine", "mesh.json", "--face-area=" + face + "=")
            self.check(f"qualityreport mesh.json --face {plain}", "qualityreport", "mesh.json", "--face", face)

    def test_names_in_quotes(self):
        self.check("qualityreport mesh.json --face 'left", "qualityreport", "mesh.json", "--face", "left cell")
        self.check('qualityreport mesh.json --face "left', "qualityreport", "mesh.json", "--face", "left cell")

    def test_names_behind_what_is_written_as_it_is(self):
        self.check("export-svg mesh.json --color field:tem", "export-svg", "mesh.json", "--color", "field:temperature")
        self.check("advect --flow cylinder:rad", "advect", "--flow", "cylinder:radius=")

    def test_files_and_inputs_with_spaces(self):
        self.check("refine in", "refine", "in lines.json")
        self.check("refine --output=not", "refine", "--output=notes.txt")
        self.check("refine in\\ lines.json --size-field tem", "refine", "in lines.json", "--size-field", "temperature")
