"""Drawing and figures of a joint, shared by commands, report and page."""
