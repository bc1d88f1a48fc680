# Generated from spec/ by generator/: edit those, then run ./dev generate.
"""The messages, structures, enums and packed integers of the protocol."""

from sbgc.fields import Axes as Axes
from sbgc.fields import Xyz as Xyz
from sbgc.msg.enums import *
from sbgc.msg.packed import *
from sbgc.msg.system import *
from sbgc.msg.parameters import *
from sbgc.msg.parameters_ext3 import *
from sbgc.msg.realtime import *
from sbgc.msg.control import *
from sbgc.msg.external_motors import *
from sbgc.msg.calibration import *
from sbgc.msg.imu import *
from sbgc.msg.peripherals import *
from sbgc.msg.modules import *
from sbgc.msg.adjustable_variables import *
from sbgc.msg.storage import *
from sbgc.msg.scripting import *
from sbgc.msg.debug import *
