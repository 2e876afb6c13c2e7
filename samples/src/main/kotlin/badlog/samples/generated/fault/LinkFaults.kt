package badlog.samples.generated.fault

import badlog.samples.generated.fault.Naming.BADLOG
import badlog.samples.generated.fault.Naming.PHOENIX
import badlog.samples.generated.fault.Naming.REV
import badlog.samples.generated.fault.Naming.WPILIB

internal val LINK_FAULTS = listOf(
    fault("link-loss", "The link to the Driver Station was lost, so the robot was disabled in the middle of the match.") {
        causes(
            "lost|loss|lose communication|communications|comms|comm|link|connection|radio",
            "driver station detached|disconnected|lost|unattached|attached",
            "radio|wifi|network interference|lost|drop|dropped|down",
            "link down|dropped|drop",
        )
        symptoms("disabled match|teleop|while|during|unexpectedly|middle|briefly|mid", "enabled lost|drop|dropped|flicker|flickers")
        strength("Away for 20 s at 1, for 6 s at 0.3.")
        starts(25.0, 110.0)
        shownBy(Signal.LINK, Signal.ENABLED)
        onlySymptom(WPILIB, PHOENIX, REV, BADLOG, because = "No topic of the link: the robot is disabled for a while, whoever did it.")
    },
    fault("controller-unplugged", "The driver's controller was unplugged, so the robot had no commands.") {
        causes(
            "controller|joystick|gamepad unplugged|disconnected|missing|lost|plugged|gone|available",
            "usb controller|joystick|gamepad",
            "joystick|controller no axes|axis|buttons",
        )
        symptoms(
            "no driver|joystick|input input|command|commands|value|values",
            "joystick|controller|axes zero|constant|frozen|idle|still",
            "robot still|standing|stands|moving|stopped enabled",
        )
        strength("Unplugged for 60 s at 1, for 4 s at 0.3.")
        starts(20.0, 85.0)
        shownBy(Signal.JOYSTICK, Signal.CONSOLE)
        onlySymptom(BADLOG, because = "The axes read 0, as if the driver let go; the console is not in a bag.")
        notSeen(PHOENIX, because = "A hoot log has no joysticks; the robot just stands, as if the driver let go.")
    },
)
