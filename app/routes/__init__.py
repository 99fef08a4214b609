"""Thin: request → one service call → response."""
