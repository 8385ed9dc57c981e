import pytest


@pytest.fixture(scope="session")
def idlers_case():
    """Case of a listed drive: rollers of 8 mm, so many in a sector, between a sun of 60 mm and a ring."""
    from asperity.joint_file.reader import parse_case

    def case(count):
        names = [f"idler_{number}" for number in range(count)]
        return parse_case(
            "\n".join(
                [
                    'type = "planar"',
                    '[drive]\nsectors = 2\ninput = "sun"\noutput = "carrier"\ngrounded = "ring"',
                    'contact_length = "10 mm"',
                    '[load]\npreload = "300 N"\noutput_torque = "5 N*m"\nsun_speed = "3000 rpm"',
                    "friction_coefficient = 0.1",
                    '[model]\ncontact_factor = "unity"\nasperity_base = "majumdar_bhushan_1991"',
                    'bodies = "exact"\nplane_state = "plane_strain"',
                    '[surface]\nfractal_dimension = 1.5\nfractal_roughness = "1.3e-7 mm"\nfrequency_ratio = 1.5',
                    "[bodies]",
                    *(f'{name} = "52100"' for name in ("sun", "ring", *names)),
                    '[[roller]]\nname = "sun"\nplace = "axis"',
                    '[[roller]]\nname = "ring"\nplace = "axis"\nwall_thickness = "8 mm"\nring_support = "free"',
                    *(
                        f'[[roller]]\nname = "{name}"\nplace = "pin"\norbit = "68 mm"\n'
                        f'angle = "{7.0 + 180.0 * number / count} deg"\n'
                        f'[[contact]]\nname = "s{number}"\nfirst = "sun"\nsecond = "{name}"\n'
                        'first_radius = "60 mm"\nsecond_radius = "8 mm"\n'
                        f'[[contact]]\nname = "r{number}"\nfirst = "{name}"\nsecond = "ring"\n'
                        'first_radius = "8 mm"\nsecond_radius = "76 mm"\ninternal = true'
                        for number, name in enumerate(names)
                    ),
                ]
            ),
            source="idlers.toml",
        )

    return case
