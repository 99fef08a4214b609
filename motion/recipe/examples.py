"""Operations that learn from other clips."""

from __future__ import annotations

from dataclasses import replace

from motion.body import REQUIRED
from motion.clip import Clip
from motion.editing.emotion_transform import EmotionTransform, apply_emotion, learn_emotion
from motion.editing.fourier import mix_cycles
from motion.recipe.feet import standing_again
from motion.recipe.operation import Context, bounded, operation
from motion.recipe.parameters import Number, Reference


def _fourier(source: Clip, context: Context, *, clip: str, amount: float) -> Clip:
    other = context.materials.clips[clip]
    duration = source.duration + amount * (other.duration - source.duration)
    bounded(duration / source.frame_time + 1)
    return mix_cycles(source, other, amount)


def _emotion(clip: Clip, context: Context, *, neutral: str, emotional: str, amount: float) -> Clip:
    if amount == 0.0:
        return clip
    emotion = _learned(clip, context, neutral, emotional, amount)
    edited = apply_emotion(clip, emotion, amount)
    return standing_again(apply_emotion(clip, replace(emotion, amplitude={}), amount), edited)


def _pace_only(
    clip: Clip, context: Context, *, neutral: str, emotional: str, amount: float
) -> Clip:
    emotion = _learned(clip, context, neutral, emotional, amount)
    return apply_emotion(clip, replace(emotion, amplitude={}), amount)


def _learned(
    clip: Clip, context: Context, neutral: str, emotional: str, amount: float
) -> EmotionTransform:
    clips = context.materials.clips
    emotion = learn_emotion(clips[neutral], clips[emotional])
    bounded((clip.frames - 1) * emotion.pace**amount + 1)
    return emotion


FOURIER = operation(
    "fourier@1",
    "Mix with another cycle",
    "Goes from this cycle to another one, or beyond it, by their Fourier series.",
    {
        "clip": Reference(
            title="Other cycle",
            description="A cyclic clip of the same skeleton.",
            kind="clip",
        ),
        "amount": Number(
            title="Amount",
            description="0 this cycle, 1 the other, more goes beyond, below 0 opposite.",
            minimum=-1.0,
            maximum=2.0,
            default=1.0,
            neutral=0.0,
        ),
    },
    _fourier,
)

EMOTION = operation(
    "emotion@1",
    "Emotion from an example",
    "Puts onto the clip what an emotion did to another action: how fast, and how wide.",
    {
        "neutral": Reference(
            title="Neutral clip",
            description="The example's action without the emotion.",
            kind="clip",
        ),
        "emotional": Reference(
            title="Emotional clip",
            description="The same action with it.",
            kind="clip",
        ),
        "amount": Number(
            title="Amount",
            description="0 none, 1 as learned, more exaggerates.",
            minimum=0.0,
            maximum=2.0,
            default=1.0,
            neutral=0.0,
        ),
    },
    _emotion,
    follow=_pace_only,
    needs=REQUIRED,
)
