"""What tests replace in the text of an example: old piece → new one."""

SPRINGS = {
    'bodies = "exact"': 'bodies = "springs"',
    'ring_support = "free" ': 'ring_support = "rigid_housing" ',
}
SKEW = '[rolling]\nskew = { sp = "0.5 mrad", pr = "-0.8 mrad" }\nhysteresis_factor = 0.01\n\n[lubrication]'
CROWNS = 'sun_crown_radius = "2 m"\nplanet_crown_radius = "3 m"\n\n[load]'
CAM = '[load]\ncam_force_per_torque = "60 N/Nm"\n'
#: Of bearings, before the next section.
BEARINGS = """[bearings]
sun_torque = "0.001 N*m"
loading_roller_torque = "0.0005 N*m"
carrier_torque = "0.005 N*m"
pin_friction_coefficient = 0.002
pin_diameter = "4 mm"
pin_length = "6 mm"
"""
