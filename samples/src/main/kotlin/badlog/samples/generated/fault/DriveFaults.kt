package badlog.samples.generated.fault

import badlog.samples.generated.fault.Naming.BADLOG
import badlog.samples.generated.fault.Naming.REV

internal val DRIVE_FAULTS = listOf(
    fault(
        "module-offset",
        "The absolute encoder of one swerve module has a wrong offset: the wheel points aside while its angle reads right.",
    ) {
        causes(
            "offset",
            "module zero|zeroed|calibrate|calibrated|calibration|alignment|misaligned|aligned",
            "wheel points|pointing|alignment|misaligned|aside|angle wrong|aside|misaligned|crooked",
            "absolute encoder wrong|zero|calibration",
        )
        symptoms(
            "module current|speed|velocity higher|lower|differs|different|slower|more|less|disagree",
            "robot drifts|veers|curves|turns|pulls",
            "odometry|pose wrong|error|drifts|differs",
            "wheels disagree|fight|fighting|scrub",
        )
        strength("The wheel is off by 30° at 1, by 9° at 0.3, for the whole match.")
        needs(Need.SWERVE)
        shownBy(Signal.MOTOR_CURRENT, Signal.MOTOR_VELOCITY, Signal.SUPPLY_CURRENT, Signal.CHANNEL_CURRENT)
        onlySymptom(REV, because = "Neither targets nor gyro: wheels disagree, which a wheel without grip or a weak motor explains, too.")
    },
    fault("module-steer-lags", "One swerve module does not turn to its angle: its steering is blocked or weak.") {
        causes(
            "steer|steering|azimuth motor|lags|behind|slow|stuck|blocked|weak|error|follow|target|setpoint",
            "turn motor stuck|blocked|weak|slow|lags|behind|error",
            "module angle not|behind|lag|lags|error|follow|reach|stuck|slow",
            "module follow|stuck|lags",
        )
        symptoms("module error|differs|different|disagree", "robot drifts|veers|curves|pulls", "wheel|wheels disagree|aside|wrong")
        strength("Its steering has 4 % of its torque at 1, 33 % at 0.3, against a friction four times the usual.")
        starts(10.0, 80.0)
        needs(Need.SWERVE)
        shownBy(Signal.MEASURED, Signal.MOTOR_POSITION, Signal.MOTOR_VELOCITY, Signal.ABSOLUTE_ENCODER)
        onlySymptom(REV, because = "Targets are not logged: the motor turns less than the others, which another path would explain, too.")
    },
    fault("module-drive-weak", "The drive motor of one swerve module gives no or too little torque; the others drag its wheel along.") {
        causes(
            "drive motor weak|dead|torque|less|little|not|failed|failing|broken",
            "module|wheel drive weak|dead|dragged|torque|less|not|power",
            "motor dead|weak|failed|broken phase|torque|drive",
            "one drive current less|lower|low|zero|no",
        )
        symptoms(
            "module current differs|different|lower|less|low|imbalance",
            "robot drifts|veers|curves|pulls",
            "imbalance|asymmetric|uneven",
        )
        strength("Its motor has no torque at 1, 30 % less than the others at 0.3 (a broken phase, a worn gear).")
        starts(10.0, 80.0)
        needs(Need.SWERVE)
        shownBy(Signal.MOTOR_CURRENT, Signal.SUPPLY_CURRENT, Signal.CHANNEL_CURRENT, Signal.MOTOR_VELOCITY)
    },
    fault(
        "dragging-brake",
        "One side of the drive drags: a brake or a bearing rubs, so it needs more current for the same speed.",
    ) {
        causes(
            "side|left|right drag|drags|dragging",
            "friction side|wheel|gearbox|drive|left|right|bearing",
            "left right current|imbalance|unequal|uneven|differ|differs|more|asymmetric",
            "side current more|higher|imbalance",
            "bearing|brake|rub|rubs|rubbing|binding side|left|right|gearbox",
        )
        symptoms("robot drifts|veers|curves|pulls|turns", "imbalance|asymmetric|uneven", "current high|higher|more")
        strength("The friction of one side takes 45 % of what its motors can give at their limit at 1, 14 % at 0.3.")
        starts(0.0, 50.0)
        needs(Need.TANK)
        shownBy(Signal.MOTOR_CURRENT, Signal.SUPPLY_CURRENT, Signal.CHANNEL_CURRENT)
    },
    fault("wheel-slip", "The wheels slip: the tread is worn, so the robot has no grip when it accelerates or brakes.") {
        causes(
            "wheel|wheels|drive|traction slip|slips|slipping|slippage",
            "tread|treads|tire|tires|traction|grip",
            "wheel spin|spins|spinning",
        )
        symptoms(
            "odometry|pose wrong|error|drifts|differs|disagree|disagrees|jumps",
            "velocity|speed jump|jumps|spike|spikes|sudden|peaks",
            "vision pose|odometry differ|differs|disagree",
            "wheels|wheel faster robot|ground|expected",
        )
        strength("The coefficient of friction is 1.1 on healthy tread: 0.35 at 1, 0.6 at 0.3.")
        shownBy(Signal.MOTOR_VELOCITY, Signal.ACCELERATION, Signal.MOTOR_CURRENT)
        onlySymptom(REV, BADLOG, because = "No acceleration or vision to compare the wheels with; their speed jumps, whatever lets it.")
    },
    fault("hot-motor", "A motor got too hot, and its controller cut its power back to protect it.") {
        causes(
            "hot|overheat|overheats|overheated|overheating",
            "temperature high|limit|protection|cut|cutback|motor|rises|too|above",
            "thermal",
        )
        symptoms("output|power|current|torque less|cut|reduced|zero|limited|low", "motor weak|stops|stopped|not")
        strength("It is at 100 °C or more, with no power at 1, with 70 % of its power at 0.3.")
        starts(40.0, 90.0)
        shownBy(Signal.MOTOR_TEMPERATURE, Signal.MOTOR_CURRENT, Signal.SUPPLY_CURRENT, Signal.CHANNEL_CURRENT, Signal.MOTOR_OUTPUT)
        onlySymptom(BADLOG, because = "Temperatures are not logged: the motor gives less, whatever the reason.")
    },
)
