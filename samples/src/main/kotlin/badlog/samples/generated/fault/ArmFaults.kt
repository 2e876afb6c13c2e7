package badlog.samples.generated.fault

import badlog.samples.generated.fault.Naming.BADLOG
import badlog.samples.generated.fault.Naming.REV

internal val ARM_FAULTS = listOf(
    fault("broken-chain", "The arm's chain broke or jumps teeth: the motor turns, but the arm does not follow.") {
        causes(
            "chain|belt|gear|gearbox|coupling|sprocket",
            "motor turns|spins|runs|free|freely|rotates|moves arm|mechanism|encoder|position|not|without|still",
            "mechanical disconnected|disconnect|broken|link|linkage",
            "decoupled|detached|sheared|stripped|skips|skipping",
        )
        symptoms(
            "arm follow|moving|move|moves|reach|reached|falls|drops|not",
            "setpoint|target missed|reached|not|never",
            "error large|persistent|position|closed",
            "current low|less|no",
        )
        strength("It carries no torque at 1; at 0.3 it slips under more than 45 % of the usual peak torque.")
        starts(15.0, 80.0)
        needs(Need.ARM)
        shownBy(Signal.MEASURED, Signal.ABSOLUTE_ENCODER, Signal.MOTOR_VELOCITY, Signal.MOTOR_CURRENT, Signal.CHANNEL_CURRENT)
    },
    fault("unplugged-encoder", "The arm's encoder is unplugged: its reading stays the same while the arm moves.") {
        causes(
            "encoder|sensor unplugged|disconnected|plugged|wire|wiring|cable|dead|broken|failed|lost|connected|missing",
            "encoder|sensor frozen|freeze|stuck|constant|flat|change|changes|zero|dropout|dropouts",
            "position frozen|constant|stuck|flat motor|output|while|although",
        )
        symptoms(
            "arm stall|stalled|stalls|stop|reach|reached|not",
            "setpoint|target missed|reached|not|never",
            "error large|persistent|position|closed",
            "current high|limit|more",
            "output full|saturated|high",
        )
        strength("Unplugged for the rest of the match at 1; for 30 % of the time, in stretches of 0.4 to 2 s, at 0.3.")
        starts(15.0, 80.0)
        needs(Need.ARM)
        shownBy(Signal.ABSOLUTE_ENCODER, Signal.MEASURED)
    },
    fault("slipping-encoder", "The arm's encoder slips on its shaft: it counts less than the arm turns, and is off more and more.") {
        causes(
            "encoder|sensor slip|slips|slipping|shaft|loose|coupling|screw|mount|mounting|disagree|disagrees|differ|differs",
            "slip|slips|slipping encoder|shaft|sensor",
            "ratio encoder|motor|changes|differs",
            "encoder motor disagree|drift|drifts|diverge|diverges",
        )
        symptoms("arm wrong|angle|position", "position drift|drifts|offset|wrong", "current high|more")
        strength("It misses 20 % of each movement up at 1, 6 % at 0.3.")
        starts(10.0, 60.0)
        needs(Need.ARM)
        shownBy(Signal.ABSOLUTE_ENCODER, Signal.MEASURED)
        notSeen(BADLOG, because = "The motor's own position is not logged, so nothing contradicts the encoder.")
    },
    fault("arm-overshoot", "The arm overshoots its setpoint and swings: its gains are wrong.") {
        causes("overshoot", "arm|position|closed gain|kp|kd|pid|tuning|tuned|damping", "arm|position oscillat", "swings|ringing|rings")
        symptoms("error large|setpoint|position|closed", "settle|settles|settling slow|long|late", "unstable|instability")
        strength("It overshoots a step by 45 % at 1, by 13 % at 0.3, and swings back and forth.")
        needs(Need.ARM)
        shownBy(Signal.MEASURED, Signal.MOTOR_OUTPUT, Signal.MOTOR_VELOCITY, Signal.ABSOLUTE_ENCODER)
        onlySymptom(REV, because = "Setpoints are not logged: the arm swings, which a hit or a pendulum would explain, too.")
    },
)
