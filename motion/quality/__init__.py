"""What an edit broke: feet that slide, joints bent too far, limbs in the body, balance lost."""

from motion.quality.check import check, ease_off
from motion.quality.report import Finding, QualityReport

__all__ = ["Finding", "QualityReport", "check", "ease_off"]
