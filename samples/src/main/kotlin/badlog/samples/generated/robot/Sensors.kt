package badlog.samples.generated.robot

import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.sin

/** A gyro that measures the heading, in rad. */
internal class Gyro(private val chance: Chance) {
    private val usualDrift = chance.normal(0.005) * PI / 180

    /** The drift, in rad/s. */
    var drift = 0.0
    private var error = 0.0

    /** The measured heading in rad; it does not wrap. */
    var yaw = 0.0
        private set

    /** The measured turning rate, in rad/s. */
    var rate = 0.0
        private set

    /** The measured acceleration along the robot, in m/s². */
    var acceleration = 0.0
        private set

    fun jump(by: Double) {
        error += by
    }

    fun step(drive: Drive, dt: Double) {
        error += (usualDrift + drift) * dt
        yaw = drive.heading + error + chance.normal(0.0002)
        rate = drive.omega + usualDrift + drift + chance.normal(0.002)
        acceleration = drive.acceleration + chance.normal(0.12)
    }
}

/** A camera that locates the robot by tags, 15 times a second when it sees some. */
internal class Camera(private val chance: Chance) {
    var x = 0.0
        private set
    var y = 0.0
        private set
    var heading = 0.0
        private set

    /** The number of positions so far. */
    var count = 0
        private set
    private var nextTime = 0.0
    private var sees = true

    /** The error of the next position, in m. */
    var nextError = 0.0

    /** Takes a picture if it is time. Returns whether there is a new position. */
    fun look(time: Double, drive: Drive): Boolean {
        if (time < nextTime) return false
        nextTime = time + 1 / 15.0
        if (chance.isIn(0.03)) sees = !sees || chance.isIn(0.4)
        val direction = chance.between(-PI, PI)
        val noise = chance.normal(0.018)
        val noise2 = chance.normal(0.018)
        val turned = chance.normal(0.008)
        if (!sees && nextError == 0.0) return false
        x = drive.x + noise + nextError * cos(direction)
        y = drive.y + noise2 + nextError * sin(direction)
        heading = wrapped(drive.heading + turned)
        nextError = 0.0
        count++
        return true
    }
}

/** The position estimated by the robot's code from wheels and gyro, corrected by the camera. */
internal class Odometry(private val drive: Drive, private val gyro: Gyro) {
    var x = drive.x
        private set
    var y = drive.y
        private set
    private var offset = 0.0
    private var isStarted = false

    val heading: Double get() = wrapped(gyro.yaw + offset)

    fun loop(dt: Double, camera: Camera?, isNew: Boolean, isLocated: Boolean) {
        if (!isStarted) {
            x = drive.x
            y = drive.y
            offset = drive.heading - gyro.yaw
            isStarted = true
        }
        var forward = 0.0
        var left = 0.0
        for (wheel in drive.wheels) {
            val speed = wheel.measuredSpeed(drive.radius)
            forward += speed * cos(wheel.measuredAngle) / drive.wheels.size
            left += speed * sin(wheel.measuredAngle) / drive.wheels.size
        }
        val direction = heading
        x += dt * (forward * cos(direction) - left * sin(direction))
        y += dt * (forward * sin(direction) + left * cos(direction))
        if (camera == null || !isNew || !isLocated) return
        x += TRUST * (camera.x - x)
        y += TRUST * (camera.y - y)
    }
}

private const val TRUST = 0.25
