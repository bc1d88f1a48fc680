# Generated from spec/ by generator/: edit those, then run ./dev generate.
"""The fourth set of parameters, of later firmware."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, ClassVar, Optional, Union

from sbgc.fields import BYTES, RAW, REAL, TEXT, Axes, AxesOf, Elements, Field, GroupOf, ListOf
from sbgc.fields import Structure, ValueOf, Xyz
from sbgc.message import Message, Request
from sbgc.msg.enums import *
from sbgc.msg.packed import *
from sbgc.values import UNSET

if TYPE_CHECKING:
    from sbgc.msg import Confirm

__all__ = [
    "ReadParamsExt3",
    "ReadParamsExt3Request",
    "ShakeGenerator",
    "WriteParamsExt3",
]

Bytes = Union[bytes, bytearray, memoryview]


class ShakeGenerator(Structure):
    """Settings of the shake generator."""

    __slots__ = ()
    _home = ("ReadParamsExt3", "shake_generator")

    amplitude: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW))
    """Amplitude of roll, tilt and pan, on a logarithmic scale."""
    base_freq: Field[float, float] = Field(REAL)
    """Lowest frequency. Unit: Hz."""
    base_freq_raw: Field[int, int] = Field(RAW, of="base_freq")
    """The number on the wire for base_freq."""
    freq_range: Field[float, float] = Field(REAL)
    """Ratio of the highest frequency to the lowest. Range: 1.5 to 11.5."""
    freq_range_raw: Field[int, int] = Field(RAW, of="freq_range")
    """The number on the wire for freq_range."""
    pause_period: Field[float, float] = Field(REAL)
    """Period of the pauses. Unit: ms."""
    pause_period_raw: Field[int, int] = Field(RAW, of="pause_period")
    """The number on the wire for pause_period."""
    pause_balance: Field[int, int] = Field(RAW)
    """Share of the pauses in their period. Range: 0 to 100."""
    pause_attenuation: Field[int, int] = Field(RAW)
    """Attenuation in the pauses. Range: 0 to 100."""
    pause_randomness: Field[int, int] = Field(RAW)
    """Randomness of the pauses. Range: 0 to 100."""
    pause_phase_var: Field[int, int] = Field(RAW)
    """Variation of the phase of the pauses between the axes. Range: 0 to 100."""
    resonance_gain: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Gain at the resonance of roll, tilt and pan. Unit: dB."""
    resonance_gain_raw: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW), of="resonance_gain")
    """The number on the wire for resonance_gain."""
    resonance_freq: Field[float, float] = Field(REAL)
    """Frequency of the resonance. Unit: Hz."""
    resonance_freq_raw: Field[int, int] = Field(RAW, of="resonance_freq")
    """The number on the wire for resonance_freq."""
    freq_shift: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW))
    """Shift of the frequencies of roll, tilt and pan, on a logarithmic scale from 1/3 to 3. Range:
    -127 to 127.
    """
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        amplitude: Axes[int] = UNSET,
        base_freq: float = UNSET,
        base_freq_raw: int = UNSET,
        freq_range: float = UNSET,
        freq_range_raw: int = UNSET,
        pause_period: float = UNSET,
        pause_period_raw: int = UNSET,
        pause_balance: int = UNSET,
        pause_attenuation: int = UNSET,
        pause_randomness: int = UNSET,
        pause_phase_var: int = UNSET,
        resonance_gain: Axes[float] = UNSET,
        resonance_gain_raw: Axes[int] = UNSET,
        resonance_freq: float = UNSET,
        resonance_freq_raw: int = UNSET,
        freq_shift: Axes[int] = UNSET,
        reserved: Bytes = UNSET,
    ) -> None:
        self._start(
            amplitude=amplitude,
            base_freq=base_freq,
            base_freq_raw=base_freq_raw,
            freq_range=freq_range,
            freq_range_raw=freq_range_raw,
            pause_period=pause_period,
            pause_period_raw=pause_period_raw,
            pause_balance=pause_balance,
            pause_attenuation=pause_attenuation,
            pause_randomness=pause_randomness,
            pause_phase_var=pause_phase_var,
            resonance_gain=resonance_gain,
            resonance_gain_raw=resonance_gain_raw,
            resonance_freq=resonance_freq,
            resonance_freq_raw=resonance_freq_raw,
            freq_shift=freq_shift,
            reserved=reserved,
        )


class ReadParamsExt3(Message):
    """The fourth set of parameters of one profile.

    CMD_READ_PARAMS_EXT3 (104), from the board; 221 bytes, and later firmware may append more.
    Since firmware 2.66. Source: Later firmware.
    """

    __slots__ = ()

    ACTIVE_PROFILE: ClassVar[int] = 255
    """For profile_id, as raw value: the active profile."""
    CAN_IMU_SERVO_DISABLED: ClassVar[int] = 0
    """For can_imu_servo_out, as raw value: disabled."""
    profile_id: Field[int, int] = Field(RAW)
    """Profile of the parameters. Range: 0 to 4. Value 255: the active profile."""
    reserved_1: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""
    ext_imu_type: Field[ExtImuModel, ExtImuModel] = Field(ValueOf(ExtImuModel))
    """Model of the external IMU. The same in all copies."""
    ext_imu_port: Field[BoardPort, BoardPort] = Field(ValueOf(BoardPort))
    """Serial port of the external IMU. The same in all copies."""
    ext_imu_position: Field[ExtImuPosition, ExtImuPosition] = Field(ValueOf(ExtImuPosition))
    """Location of the external IMU. The same in all copies."""
    ext_imu_orientation: Field[ExtImuOrientation, int] = Field(ValueOf(ExtImuOrientation))
    """Orientation of the external IMU. The same in all copies."""
    ext_imu_flags: Field[ExtImuFlags, ExtImuFlags] = Field(ValueOf(ExtImuFlags))
    """Use of the external IMU. The same in all copies."""
    ext_imu_align_correction: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW))
    """Correction of the orientation of the external IMU, in unknown units. Unconfirmed."""
    ext_imu_startup_delay: Field[int, int] = Field(RAW)
    """Delay until the external IMU is used, in unknown units. Unconfirmed."""
    ext_imu_gyro_corr_rate: Field[int, int] = Field(RAW)
    """Rate at which the external IMU corrects the gyroscope. Unconfirmed."""
    reserved_2: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""
    soft_limit_width: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Width of the software limits FRAME_CAM_ANGLE_MIN and FRAME_CAM_ANGLE_MAX. Unit: deg."""
    soft_limit_width_raw: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW), of="soft_limit_width")
    """The number on the wire for soft_limit_width."""
    adc_replace_src: Field[Elements[RcMap], Iterable[int]] = Field(ListOf(ValueOf(RcMap)))
    """Signals that replace ADC1, ADC2 and ADC3."""
    glock_mid_mot_pos_corr_rate: Field[int, int] = Field(RAW)
    """Rate at which the position of the middle motor is corrected near gimbal lock."""
    extra_btn_cfg: Field[Elements[ExtraButton], Iterable[int]] = Field(ListOf(ValueOf(ExtraButton)))
    """Pins of additional buttons."""
    overcurrent_protection: Field[float, float] = Field(REAL)
    """Current at which the power switch turns off. Unit: mA."""
    overcurrent_protection_raw: Field[int, int] = Field(RAW, of="overcurrent_protection")
    """The number on the wire for overcurrent_protection."""
    power_on_delay: Field[float, float] = Field(REAL)
    """Delay before the power switch turns on. Unit: ms."""
    power_on_delay_raw: Field[int, int] = Field(RAW, of="power_on_delay")
    """The number on the wire for power_on_delay."""
    power_off_delay: Field[float, float] = Field(REAL)
    """Delay before the power switch turns off. Unit: ms."""
    power_off_delay_raw: Field[int, int] = Field(RAW, of="power_off_delay")
    """The number on the wire for power_off_delay."""
    power_on_limiter: Field[int, int] = Field(RAW)
    """Limit of the current while the power switch turns on."""
    reserved_3: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""
    lpf_q_inv: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Inverse quality factor of the low-pass filter."""
    lpf_q_inv_raw: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW), of="lpf_q_inv")
    """The number on the wire for lpf_q_inv."""
    can_imu_ext_sens_type: Field[CanImuSensor, CanImuSensor] = Field(ValueOf(CanImuSensor))
    """External sensor of the CAN IMU. The same in all copies."""
    profile_flags2: Field[ProfileFlags2, ProfileFlags2] = Field(ValueOf(ProfileFlags2))
    """More options of the profile."""
    reserved_4: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""
    general_flags3: Field[GeneralFlags3, GeneralFlags3] = Field(ValueOf(GeneralFlags3))
    """Still more options of the whole board. The same in all copies."""
    follow_offset_ext: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Offset of the follow mode. Range: -360 to 360 deg. Since firmware 2.70."""
    follow_offset_ext_raw: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW), of="follow_offset_ext")
    """The number on the wire for follow_offset_ext."""
    motor_startup_delay: Field[float, float] = Field(REAL)
    """Delay before the motors start. Unit: ms."""
    motor_startup_delay_raw: Field[int, int] = Field(RAW, of="motor_startup_delay")
    """The number on the wire for motor_startup_delay."""
    imu_model_main: Field[int, int] = Field(RAW)
    """Model of the main IMU. The same in all copies."""
    imu_model_frame: Field[int, int] = Field(RAW)
    """Model of the frame IMU. The same in all copies."""
    stab_threshold_angle: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Angle between motor and axis up to which the motor stabilizes. Range: 15 to 80 deg. Raw value
    0: not set.
    """
    stab_threshold_angle_raw: Field[Axes[int], Axes[int]] = Field(
        AxesOf(RAW),
        of="stab_threshold_angle",
    )
    """The number on the wire for stab_threshold_angle."""
    ext_buzzer_pin: Field[OutputPin, OutputPin] = Field(ValueOf(OutputPin))
    """Pin of an additional buzzer. The same in all copies."""
    enc_limit_return_speed: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW))
    """Speed of the return from beyond a limit."""
    tripod_mode_auto_threshold: Field[int, int] = Field(RAW)
    """Threshold at which the tripod mode starts automatically."""
    rc_deadband_pitch: Field[int, int] = Field(RAW)
    """Dead band of the RC signal of pitch, with RC_EXPO_DEADBAND_SPLIT."""
    rc_deadband_yaw: Field[int, int] = Field(RAW)
    """Dead band of the RC signal of yaw, with RC_EXPO_DEADBAND_SPLIT."""
    rc_expo_rate_pitch: Field[int, int] = Field(RAW)
    """Expo rate of the RC signal of pitch, with RC_EXPO_DEADBAND_SPLIT."""
    rc_expo_rate_yaw: Field[int, int] = Field(RAW)
    """Expo rate of the RC signal of yaw, with RC_EXPO_DEADBAND_SPLIT."""
    profile_flags3: Field[ProfileFlags3, ProfileFlags3] = Field(ValueOf(ProfileFlags3))
    """Still more options of the profile."""
    default_profile: Field[int, int] = Field(RAW)
    """Profile after a restart. Range: 0 to 4. The same in all copies."""
    retracted_angle: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW))
    """Angle of the retracted position, in unknown units."""
    shake_generator: Field[ShakeGenerator, ShakeGenerator] = Field(GroupOf(ShakeGenerator))
    """Settings of the shake generator."""
    ext_motor_drv_ids: Field[Elements[int], Iterable[int]] = Field(ListOf(RAW))
    """CAN drivers of the external motors 1 to 7."""
    encoder_cfg_ext: Field[Axes[EncoderConfigExt], Axes[EncoderConfigExt]] = Field(
        AxesOf(ValueOf(EncoderConfigExt)),
    )
    """Resolution and turns of the encoder."""
    ext_sens_params: Field[bytes, Bytes] = Field(BYTES)
    """Settings of the CAN IMU's external sensor; they depend on its model."""
    imu_angle_corr_r: Field[float, float] = Field(REAL)
    """Correction of the roll angle. Unit: deg. Positive pitch is down, negative up; positive yaw is
    right, negative left; for roll it is not known.
    """
    imu_angle_corr_r_raw: Field[int, int] = Field(RAW, of="imu_angle_corr_r")
    """The number on the wire for imu_angle_corr_r."""
    imu_angle_corr_p: Field[float, float] = Field(REAL)
    """Correction of the pitch angle. Unit: deg. Positive pitch is down, negative up; positive yaw
    is right, negative left; for roll it is not known.
    """
    imu_angle_corr_p_raw: Field[int, int] = Field(RAW, of="imu_angle_corr_p")
    """The number on the wire for imu_angle_corr_p."""
    can_imu_servo_out: Field[Elements[int], Iterable[int]] = Field(ListOf(RAW))
    """Virtual channel on each servo pin of the CAN IMU. Range: 1 to 32. Value 0: disabled."""
    can_imu_servo_rate: Field[float, float] = Field(REAL)
    """PWM frequency of these servo outputs. Unit: Hz."""
    can_imu_servo_rate_raw: Field[int, int] = Field(RAW, of="can_imu_servo_rate")
    """The number on the wire for can_imu_servo_rate."""
    servo_outer_p_mult: Field[int, int] = Field(RAW)
    """Factor on OUTER_P in servo mode: 0.1 * exp(raw * ln(500) / 255)."""
    servo_outer_i: Field[int, int] = Field(RAW)
    """Integral gain of the outer loop in servo mode: 5 * exp(raw * ln(52) / 255) - 5."""
    ext_pwr_sw_shunt_r: Field[float, float] = Field(REAL)
    """Shunt resistance of an external power switch. Unit: ohm. The same in all copies."""
    ext_pwr_sw_shunt_r_raw: Field[int, int] = Field(RAW, of="ext_pwr_sw_shunt_r")
    """The number on the wire for ext_pwr_sw_shunt_r."""
    general_flags4: Field[GeneralFlags4, GeneralFlags4] = Field(ValueOf(GeneralFlags4))
    """The last options of the whole board. The same in all copies."""
    auto_motion_timeout: Field[int, int] = Field(RAW)
    """Time limit of automatic motions, in unknown units. Unconfirmed."""
    reserved_5: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        profile_id: int = UNSET,
        reserved_1: Bytes = UNSET,
        ext_imu_type: ExtImuModel = UNSET,
        ext_imu_port: BoardPort = UNSET,
        ext_imu_position: ExtImuPosition = UNSET,
        ext_imu_orientation: int = UNSET,
        ext_imu_flags: ExtImuFlags = UNSET,
        ext_imu_align_correction: Axes[int] = UNSET,
        ext_imu_startup_delay: int = UNSET,
        ext_imu_gyro_corr_rate: int = UNSET,
        reserved_2: Bytes = UNSET,
        soft_limit_width: Axes[float] = UNSET,
        soft_limit_width_raw: Axes[int] = UNSET,
        adc_replace_src: Iterable[int] = UNSET,
        glock_mid_mot_pos_corr_rate: int = UNSET,
        extra_btn_cfg: Iterable[int] = UNSET,
        overcurrent_protection: float = UNSET,
        overcurrent_protection_raw: int = UNSET,
        power_on_delay: float = UNSET,
        power_on_delay_raw: int = UNSET,
        power_off_delay: float = UNSET,
        power_off_delay_raw: int = UNSET,
        power_on_limiter: int = UNSET,
        reserved_3: Bytes = UNSET,
        lpf_q_inv: Axes[float] = UNSET,
        lpf_q_inv_raw: Axes[int] = UNSET,
        can_imu_ext_sens_type: CanImuSensor = UNSET,
        profile_flags2: ProfileFlags2 = UNSET,
        reserved_4: Bytes = UNSET,
        general_flags3: GeneralFlags3 = UNSET,
        follow_offset_ext: Axes[float] = UNSET,
        follow_offset_ext_raw: Axes[int] = UNSET,
        motor_startup_delay: float = UNSET,
        motor_startup_delay_raw: int = UNSET,
        imu_model_main: int = UNSET,
        imu_model_frame: int = UNSET,
        stab_threshold_angle: Axes[float] = UNSET,
        stab_threshold_angle_raw: Axes[int] = UNSET,
        ext_buzzer_pin: OutputPin = UNSET,
        enc_limit_return_speed: Axes[int] = UNSET,
        tripod_mode_auto_threshold: int = UNSET,
        rc_deadband_pitch: int = UNSET,
        rc_deadband_yaw: int = UNSET,
        rc_expo_rate_pitch: int = UNSET,
        rc_expo_rate_yaw: int = UNSET,
        profile_flags3: ProfileFlags3 = UNSET,
        default_profile: int = UNSET,
        retracted_angle: Axes[int] = UNSET,
        shake_generator: ShakeGenerator = UNSET,
        ext_motor_drv_ids: Iterable[int] = UNSET,
        encoder_cfg_ext: Axes[EncoderConfigExt] = UNSET,
        ext_sens_params: Bytes = UNSET,
        imu_angle_corr_r: float = UNSET,
        imu_angle_corr_r_raw: int = UNSET,
        imu_angle_corr_p: float = UNSET,
        imu_angle_corr_p_raw: int = UNSET,
        can_imu_servo_out: Iterable[int] = UNSET,
        can_imu_servo_rate: float = UNSET,
        can_imu_servo_rate_raw: int = UNSET,
        servo_outer_p_mult: int = UNSET,
        servo_outer_i: int = UNSET,
        ext_pwr_sw_shunt_r: float = UNSET,
        ext_pwr_sw_shunt_r_raw: int = UNSET,
        general_flags4: GeneralFlags4 = UNSET,
        auto_motion_timeout: int = UNSET,
        reserved_5: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            profile_id=profile_id,
            reserved_1=reserved_1,
            ext_imu_type=ext_imu_type,
            ext_imu_port=ext_imu_port,
            ext_imu_position=ext_imu_position,
            ext_imu_orientation=ext_imu_orientation,
            ext_imu_flags=ext_imu_flags,
            ext_imu_align_correction=ext_imu_align_correction,
            ext_imu_startup_delay=ext_imu_startup_delay,
            ext_imu_gyro_corr_rate=ext_imu_gyro_corr_rate,
            reserved_2=reserved_2,
            soft_limit_width=soft_limit_width,
            soft_limit_width_raw=soft_limit_width_raw,
            adc_replace_src=adc_replace_src,
            glock_mid_mot_pos_corr_rate=glock_mid_mot_pos_corr_rate,
            extra_btn_cfg=extra_btn_cfg,
            overcurrent_protection=overcurrent_protection,
            overcurrent_protection_raw=overcurrent_protection_raw,
            power_on_delay=power_on_delay,
            power_on_delay_raw=power_on_delay_raw,
            power_off_delay=power_off_delay,
            power_off_delay_raw=power_off_delay_raw,
            power_on_limiter=power_on_limiter,
            reserved_3=reserved_3,
            lpf_q_inv=lpf_q_inv,
            lpf_q_inv_raw=lpf_q_inv_raw,
            can_imu_ext_sens_type=can_imu_ext_sens_type,
            profile_flags2=profile_flags2,
            reserved_4=reserved_4,
            general_flags3=general_flags3,
            follow_offset_ext=follow_offset_ext,
            follow_offset_ext_raw=follow_offset_ext_raw,
            motor_startup_delay=motor_startup_delay,
            motor_startup_delay_raw=motor_startup_delay_raw,
            imu_model_main=imu_model_main,
            imu_model_frame=imu_model_frame,
            stab_threshold_angle=stab_threshold_angle,
            stab_threshold_angle_raw=stab_threshold_angle_raw,
            ext_buzzer_pin=ext_buzzer_pin,
            enc_limit_return_speed=enc_limit_return_speed,
            tripod_mode_auto_threshold=tripod_mode_auto_threshold,
            rc_deadband_pitch=rc_deadband_pitch,
            rc_deadband_yaw=rc_deadband_yaw,
            rc_expo_rate_pitch=rc_expo_rate_pitch,
            rc_expo_rate_yaw=rc_expo_rate_yaw,
            profile_flags3=profile_flags3,
            default_profile=default_profile,
            retracted_angle=retracted_angle,
            shake_generator=shake_generator,
            ext_motor_drv_ids=ext_motor_drv_ids,
            encoder_cfg_ext=encoder_cfg_ext,
            ext_sens_params=ext_sens_params,
            imu_angle_corr_r=imu_angle_corr_r,
            imu_angle_corr_r_raw=imu_angle_corr_r_raw,
            imu_angle_corr_p=imu_angle_corr_p,
            imu_angle_corr_p_raw=imu_angle_corr_p_raw,
            can_imu_servo_out=can_imu_servo_out,
            can_imu_servo_rate=can_imu_servo_rate,
            can_imu_servo_rate_raw=can_imu_servo_rate_raw,
            servo_outer_p_mult=servo_outer_p_mult,
            servo_outer_i=servo_outer_i,
            ext_pwr_sw_shunt_r=ext_pwr_sw_shunt_r,
            ext_pwr_sw_shunt_r_raw=ext_pwr_sw_shunt_r_raw,
            general_flags4=general_flags4,
            auto_motion_timeout=auto_motion_timeout,
            reserved_5=reserved_5,
            tail=tail,
        )


class ReadParamsExt3Request(Request["ReadParamsExt3"]):
    """Request the fourth set of parameters of one profile.

    CMD_READ_PARAMS_EXT3 (104), to the board; 1 byte. Effect: reads. Since firmware 2.66.
    Source: Later firmware.
    """

    __slots__ = ()

    ACTIVE_PROFILE: ClassVar[int] = 255
    """For profile_id, as raw value: the active profile."""
    profile_id: Field[int, int] = Field(RAW)
    """Profile to read. Range: 0 to 4. Value 255: the active profile."""

    def __init__(self, *, profile_id: int = UNSET, tail: Bytes = UNSET) -> None:
        self._start(profile_id=profile_id, tail=tail)


class WriteParamsExt3(ReadParamsExt3, Request["Confirm"]):
    """Store the fourth set of parameters of one profile.

    CMD_WRITE_PARAMS_EXT3 (105), to the board; 221 bytes, and later firmware may append more.
    Effect: stores, moves. Since firmware 2.66. Source: Later firmware.
    """

    __slots__ = ()
