package badlog.samples.generated.fault

import badlog.samples.generated.fault.Naming.BADLOG
import badlog.samples.generated.fault.Naming.PHOENIX
import badlog.samples.generated.fault.Naming.REV

internal val LOCATION_FAULTS = listOf(
    fault("gyro-drift", "The gyro drifts: its heading changes while the robot stands still.") {
        causes(
            "gyro|imu|pigeon|navx|yaw|heading drift|drifts|drifting|bias|calibrate|calibration|calibrated|temperature",
            "yaw|heading changes|moves|turns still|standing|stationary|disabled",
        )
        symptoms(
            "heading|yaw wrong|error|differs|disagree|disagrees",
            "field relative|oriented wrong",
            "pose|odometry wrong|error|drifts|differs|disagree",
        )
        strength("1 °/s at 1, 0.3 °/s at 0.3. Healthy: 0.005 °/s.")
        shownBy(Signal.GYRO)
        notSeen(REV, because = "A revlog has no gyro.")
    },
    fault("gyro-reset", "The gyro lost its heading in the match: it started again, or code zeroed it.") {
        causes(
            "gyro|imu|pigeon|navx|yaw|heading reset|resets|restart|restarted|reboot|rebooted|zeroed|jump|jumps|jumped|lost|step",
            "heading|yaw sudden|suddenly",
        )
        symptoms(
            "field relative|oriented wrong",
            "pose|odometry jump|jumps|wrong|error|differs|disagree",
            "heading|yaw wrong|error|differs|disagree",
        )
        strength("At a hit the heading jumps by 90° or more at 1, by 27° at 0.3 (a gyro that was away for a moment).")
        starts(20.0, 100.0)
        shownBy(Signal.GYRO)
        notSeen(REV, because = "A revlog has no gyro.")
    },
    fault("vision-jumps", "The camera reports wrong positions now and then, and the robot believes them.") {
        causes(
            "vision|camera|apriltag|tag|limelight|photon jump|outlier|wrong|ambigu|reject|nois|bad|far|measurement|disagree",
        )
        symptoms("pose|position|odometry jump|jumps|jumped|teleport|teleports|wrong|discontinuous", "pose impossible|speed|speeds")
        strength("Every 3 s a position 3 m off at 1, 0.9 m off at 0.3.")
        starts(10.0, 40.0)
        needs(Need.VISION)
        shownBy(Signal.VISION_POSE, Signal.POSE)
        onlySymptom(PHOENIX, BADLOG, because = "What the camera reports is not logged, only the pose that jumps with it.")
        notSeen(REV, because = "A revlog has neither camera nor pose.")
    },
)
