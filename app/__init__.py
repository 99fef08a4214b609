"""Manner's web server: routes → services → persistence, motion, statistics, figures."""
