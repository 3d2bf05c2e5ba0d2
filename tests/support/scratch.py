"""Tests that run in a folder of their own."""
import os
import tempfile
import unittest


class InScratch(unittest.TestCase):
    """The tests of a class start in an empty folder, which goes when they have ended."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        os.chdir(cls.folder.name)

    @classmethod
    def tearDownClass(cls):
        os.chdir("/")
        cls.folder.cleanup()
