package badlog.formats.wpilog

import kotlin.math.cos
import kotlin.math.sin

/**
 * Ten seconds of a robot with a swerve drive that logs everything, as real logs do. It has hundreds of topics of dashboards and autonomous paths that
 * never change, dozens that were never written to, structs, arrays, joysticks, and among them the robot's own values. More than 700 topics.
 */
internal fun largeLog(): ByteArray = LargeLog().bytes()

private class LargeLog {
    private val log = TestLog()
    private var nextId = 1
    private val changes = ArrayList<(second: Double, micros: Long) -> Unit>()

    fun bytes(): ByteArray {
        schemas()
        driverStation()
        chassis()
        mechanisms()
        cameras()
        settings()
        for (step in 0..STEPS) for (change in changes) change(step * 0.1, step * 100_000L + 1)
        return log.bytes
    }

    private fun start(name: String, type: String): Int = nextId++.also { log.start(it, name, type) }

    /** A topic of [type] that is written ten times a second. */
    private fun stream(name: String, type: String, payload: (second: Double) -> ByteArray) {
        val id = start(name, type)
        changes += { second, micros -> log.record(id, micros, payload(second)) }
    }

    /** A topic of [type] that is written once. */
    private fun once(name: String, type: String, payload: ByteArray) {
        log.record(start(name, type), 0, payload)
    }

    private fun schemas() {
        for ((struct, fields) in listOf(
            "Translation2d" to "double x;double y",
            "Rotation2d" to "double value",
            "Pose2d" to "Translation2d translation;Rotation2d rotation",
            "SwerveModuleState" to "double speed;Rotation2d angle",
            "ChassisSpeeds" to "double vx;double vy;double omega",
        )) {
            once("/.schema/struct:$struct", "structschema", fields.encodeToByteArray())
        }
    }

    private fun driverStation() {
        stream("DS:enabled", "boolean") { byteArrayOf(if (it > 1) 1 else 0) }
        stream("DS:autonomous", "boolean") { byteArrayOf(if (it < 4) 1 else 0) }
        once("DS:estop", "boolean", byteArrayOf(0))
        for (stick in 0..5) {
            val isUsed = stick < 2
            val name = "DS:joystick$stick"
            val axes = { second: Double -> FloatArray(6) { if (isUsed) sin(second + it).toFloat() else 0f } }
            val buttons = { second: Double -> ByteArray(12) { if (isUsed && (second * 3).toInt() % 13 == it) 1 else 0 } }
            if (isUsed) {
                stream("$name/axes", "float[]") { floats(*axes(it)) }
                stream("$name/buttons", "boolean[]", buttons)
            } else {
                once("$name/axes", "float[]", floats(*axes(0.0)))
                once("$name/buttons", "boolean[]", buttons(0.0))
            }
            once("$name/povs", "int64[]", longs(-1))
        }
    }

    private fun chassis() {
        MODULES.forEachIndexed { i, module ->
            stream("/Chassis/Target${module}ModuleState", "struct:SwerveModuleState") { doubles(2 * sin(it), it / 5 + i) }
            stream("/Chassis/Actual${module}ModuleState", "struct:SwerveModuleState") { doubles(2 * sin(it - 0.2), it / 5 + i - 0.05) }
        }
        stream("/Chassis/TargetSpeed", "struct:ChassisSpeeds") { doubles(sin(it), cos(it), 0.1 * it) }
        stream("/Chassis/ActualSpeed", "struct:ChassisSpeeds") { doubles(sin(it - 0.2), cos(it - 0.2), 0.1 * it) }
        stream("/Chassis/Pose", "struct:Pose2d") { doubles(it, 2 * it, it / 3) }
        stream("/Chassis/DriveState", "string") { (if (it < 5) "HOLD" else "DRIVE").encodeToByteArray() }
        stream("/PowerDistribution/Voltage", "double") { doubles(12.5 - it / 10) }
        stream("/PowerDistribution/TotalCurrent", "double") { doubles(20 + 5 * sin(it)) }
        stream("/PowerDistribution/ChannelCurrent", "double[]") { second -> doubles(*DoubleArray(24) { it + sin(second) }) }
    }

    private fun mechanisms() {
        for (name in listOf("Elevator", "Arm", "Wrist", "Intake", "Shooter", "Climber")) {
            stream("/$name/Setpoint", "double") { doubles(if (it < 5) 0.0 else 1.0) }
            stream("/$name/Position", "double") { doubles(if (it < 5.5) 0.0 else 0.98) }
            for (measure in listOf("Output", "SupplyCurrent", "StatorCurrent", "Temperature", "Error", "Velocity")) {
                stream("/$name/$measure", "double") { doubles(sin(it * (measure.length + name.length))) }
            }
            stream("/$name/AtGoal", "boolean") { byteArrayOf(if (it > 6) 1 else 0) }
            stream("/$name/State", "string") { (if (it < 5) "IDLE" else "MOVING").encodeToByteArray() }
            once("/$name/Connected", "boolean", byteArrayOf(1))
        }
    }

    private fun cameras() {
        for (camera in listOf("limelight-front", "limelight-back")) {
            for (pose in listOf("botpose", "botpose_wpiblue", "botpose_wpired", "camerapose_targetspace", "targetpose_cameraspace")) {
                stream("NT:/$camera/$pose", "double[]") { second -> doubles(*DoubleArray(6) { second * it }) }
            }
            for (name in listOf("tx", "ty", "ta", "tl", "hb")) stream("NT:/$camera/$name", "double") { doubles(cos(it * name.length)) }
            for (name in listOf("ledMode", "camMode", "stream", "snapshot", "pipeline")) once("NT:/$camera/$name", "double", doubles(0.0))
        }
    }

    private fun settings() {
        for (step in 0 until 30) {
            for (name in listOf("Time", "Heading", "vision alignment", "note state", "climber state", "num zones", "start", "end")) {
                once("NT:/Primitive $step/$name", "double", doubles(step + name.length / 2.0))
            }
            for (name in listOf("Primitive ID", "Heading Option", "Path Name", "note change", "climber change")) {
                once("NT:/Primitive $step/$name", "string", "$name of $step".encodeToByteArray())
            }
        }
        for (name in List(28) { "NT:/photonvision/camera $it/inputSaveImgCmd" }) start(name, "int64")
    }

    private companion object {
        const val STEPS = 100
        val MODULES = listOf("FrontLeft", "FrontRight", "BackLeft", "BackRight")
    }
}
