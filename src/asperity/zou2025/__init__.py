"""The paper by Zou et al. (Materials 2025, 18(12), 2866): its statics, its cases, its figures and what it claims."""
