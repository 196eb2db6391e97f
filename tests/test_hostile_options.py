# SPDX-License-Identifier: Apache-2.0
"""Options and outputs that ask for the impossible: a clear error, soon, in little memory."""

import unittest

from program import SCENE, ProgramTest

REFUSED = {
    "image of 10^9 x 10^9": ("+W1000000000", "+H1000000000"),
    "image of 10^5 x 10^5": ("+W100000", "+H100000"),
    "image of 0 x 0": ("+W0", "+H0"),
    "negative image": ("+W-5", "+H-5"),
    "width that is no number": ("+Wten", "+H10"),
    "number beyond every range": ("+W99999999999999999999999", "+H10"),
    "unknown options": ("+Z99", "--foo"),
    "unknown integrator": ("--integrator", "nonsense"),
    "unknown accelerator": ("--accelerator", "nonsense"),
    "width of 10^9": ("+W1000000000",),
    "width that is not finite": ("+Winf",),
    "more threads than any machine has": ("+WT1000000",),
    "frame beyond every range": ("+KFF99999999999999999999",),
    "quality of 99": ("+Q99",),
    "switch that is neither on nor off": ("Antialias=perhaps",),
    "language of the future": ("+MV99",),
    "shell command": ("Post_Scene_Command=touch here",),
    "more pixels than allowed": ("+W100", "+H100", "--max-pixels", "9999"),
    "file of settings that includes itself": ("self.ini",),
    "file of settings that is a folder": ("folder.ini",),
    "file of settings that is not there": ("none.ini",),
}

# Every key of POV-Ray's manual, chapter "INI Options", with a value that asks for something.
KEYS = {
    "Clock": "1", "Initial_Frame": "0", "Final_Frame": "2", "Initial_Clock": "0",
    "Final_Clock": "1", "Subset_Start_Frame": "0", "Subset_End_Frame": "0", "Frame_Step": "1",
    "Cyclic_Animation": "on", "Height": "8", "Width": "8", "Max_Image_Buffer_Memory": "128",
    "Start_Column": "1", "Start_Row": "1", "End_Column": "8", "End_Row": "8", "Test_Abort": "on",
    "Test_Abort_Count": "10", "Create_Ini": "off", "Display": "on", "Video_Mode": "1",
    "Palette": "0", "Display_Gamma": "2.2", "Pause_When_Done": "off", "Verbose": "on",
    "Draw_Vistas": "off", "Preview_Start_Size": "1", "Preview_End_Size": "1",
    "Output_File_Type": "n", "Output_Alpha": "off", "Bits_Per_Color": "8", "Compression": "5",
    "Dither": "off", "Dither_Method": "fs", "File_Gamma": "2.2", "Include_Header": "head.inc",
    "Library_Path": ".", "Version": "3.7", "Post_Frame_Return": "I", "Pre_Scene_Return": "I",
    "Pre_Frame_Return": "I", "Post_Scene_Return": "I", "User_Abort_Return": "I",
    "Fatal_Error_Return": "I", "Debug_Console": "off", "Fatal_Console": "on",
    "Render_Console": "on", "Statistic_Console": "off", "Warning_Console": "on",
    "All_Console": "on", "Debug_File": "off", "Fatal_File": "off", "Render_File": "off",
    "Statistic_File": "off", "Warning_File": "off", "All_File": "off", "Append_File": "off",
    "Warning_Level": "10", "Quality": "9", "Bounding": "on", "Bounding_Method": "1",
    "Bounding_Threshold": "3", "Light_Buffer": "on", "Vista_Buffer": "on", "Remove_Bounds": "on",
    "Split_Unions": "off", "Antialias": "off", "Sampling_Method": "1", "Antialias_Threshold": "0.3",
    "Antialias_Gamma": "2.5", "Jitter": "on", "Jitter_Amount": "1", "Antialias_Depth": "3",
    "High_Reproducibility": "on", "Work_Threads": "1", "Radiosity_Vain_Pretrace": "on",
    "Radiosity_From_File": "off", "Radiosity_To_File": "off", "Radiosity_File_Name": "a",
    "Render_Pattern": "0", "Render_Block_Size": "32", "Render_Block_Step": "0",
    "Output_to_File": "on",
}
IN_VAIN = {
    "Field_Render": "on", "Odd_Field": "on", "Continue_Trace": "on", "Grayscale_Output": "on",
    "Create_Ini": "a.ini", "Pause_When_Done": "on", "Draw_Vistas": "on", "BSP_MaxDepth": "64",
    "BSP_IsectCost": "1", "BSP_BaseAccessCost": "1", "BSP_ChildAccessCost": "1",
    "BSP_MissChance": "0.5", "Bounding": "off", "Bounding_Method": "2", "Bounding_Threshold": "9",
    "Light_Buffer": "off", "Vista_Buffer": "off", "Remove_Bounds": "off", "Split_Unions": "on",
    "All_File": "a.txt", "Append_File": "on", "Debug_File": "a.txt", "Warning_File": "a.txt",
    "Radiosity_To_File": "on", "Radiosity_From_File": "on", "Render_Pattern": "2",
    "Render_Block_Size": "64", "Preview_Start_Size": "8", "Max_Image_Buffer_Memory": "1",
}


class HostileOptions(ProgramTest):
    def test_impossible_options_are_refused(self):
        self.write("a.pov", SCENE)
        self.write("self.ini", "self.ini\n")
        (self.folder / "folder.ini").mkdir()
        for name, options in REFUSED.items():
            with self.subTest(case=name):
                outcome = self.dioptre("+Ia.pov", "+Oa.png", "-D", *options, cpu_seconds=10)
                self.assertGreater(outcome.status, 0, outcome.output)
                self.assertLess(outcome.cpu_seconds, 2)
                self.assertLess(outcome.peak_bytes, 512 << 20)
                self.assertTrue(outcome.output.strip())
                self.assertFalse((self.folder / "a.png").exists())

    def test_every_key_of_pov_ray_is_known(self):
        self.write("a.pov", SCENE)
        self.write("head.inc", "// nothing\n")
        for key, value in KEYS.items():
            with self.subTest(key=key):
                self.assertEqual(self.tiny(f"{key}={value}").output, "")

    def test_what_has_no_effect_is_said_once(self):
        self.write("a.pov", SCENE)
        for key, value in IN_VAIN.items():
            with self.subTest(key=key):
                outcome = self.tiny(f"{key}={value}", f"{key}={value}")
                self.assertEqual(outcome.output, f"dioptre: warning: {key} has no effect\n")

    def test_10_to_9_frames_may_begin_and_be_stopped(self):
        self.write("a.pov", SCENE)
        outcome = self.dioptre("+Ia.pov", "+Oa.ppm", "+FP", "+W8", "+H8", "-D", "+KFF1000000000",
                               "--progress=none", cpu_seconds=20, interrupt_after=0.5)
        self.assertEqual(outcome.status, 2, outcome.output)
        self.assertTrue((self.folder / "a0000000001.ppm").exists())
        self.assertLess(outcome.peak_bytes, 512 << 20)

    def tiny(self, *options):
        outcome = self.dioptre("+Ia.pov", "+Oa.png", "+W8", "+H8", "-D", "--progress=none", *options,
                               cpu_seconds=10)
        self.assertEqual(outcome.status, 0, outcome.output)
        return outcome

    def test_a_folder_is_not_a_scene(self):
        (self.folder / "folder.pov").mkdir()
        outcome = self.dioptre("+Ifolder.pov", "+Oa.png", "-D", cpu_seconds=10)
        self.assertGreater(outcome.status, 0)
        self.assertIn("folder.pov", outcome.output)


if __name__ == "__main__":
    unittest.main()
