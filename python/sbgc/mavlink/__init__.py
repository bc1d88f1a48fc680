"""Exposes gimbals as MAVLink devices, for autopilots and ground stations: `python -m sbgc.mavlink -h`.

It needs pymavlink: `pip install sbgc[mavlink]`. The Gimbal Protocol v2 is that of
https://mavlink.io/en/services/gimbal_v2.html, the messages are those of common.xml.
"""

import logging

LOG = logging.getLogger("sbgc.mavlink")
