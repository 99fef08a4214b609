"""What a motion looks like in numbers: the 51 features of Oshita et al., and named gait measures.

Oshita et al., Motion interpolation using adjectives, section 5, tables 4 and 5.
"""

from motion.features.definitions import FEATURE_GROUPS, FEATURES, Feature
from motion.features.measure import features

__all__ = ["FEATURES", "FEATURE_GROUPS", "Feature", "features"]
