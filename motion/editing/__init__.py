"""Edits that change how a motion feels and leave what it does (Förger, chapter 3)."""
