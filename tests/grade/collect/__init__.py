"""collect - what is a submission, and the answers that are found in it."""
