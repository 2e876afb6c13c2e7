package badlog.samples.generated.robot

import badlog.samples.generated.fault.Naming
import badlog.samples.generated.fault.Need
import kotlin.math.PI

/** All parts of a simulated robot. */
internal class Robot(val plan: RobotPlan) {
    private val seed = plan.seed
    private val build = Chance(seed, "build")
    val devices = ArrayList<Device>()

    /** Whether it has a roboRIO 2, which protects itself from brownouts earlier. */
    val isSecondRio = build.isIn(0.6)
    val battery = Battery(
        restVolts = if (plan.hardship == Hardship.AGED_BATTERY) 12.55 else build.between(12.6, 12.85),
        resistance = if (plan.hardship == Hardship.AGED_BATTERY) 0.026 else build.between(0.015, 0.021),
    )
    val isSwerve = Need.SWERVE in plan.parts
    val drive = drive()
    val elevator = if (Need.ELEVATOR in plan.parts) elevator() else null
    val arm = if (Need.ARM in plan.parts) arm() else null
    val shooter = if (Need.SHOOTER in plan.parts) shooter() else null
    val intake = if (Need.INTAKE in plan.parts) intake() else null
    val air = if (Need.PNEUMATICS in plan.parts) Air(Chance(seed, "air"), build.between(85.0, 118.0)) else null
    val gyro = Gyro(Chance(seed, "gyro"))
    val camera = if (Need.VISION in plan.parts) Camera(Chance(seed, "camera")) else null
    val computer = Computer(Chance(seed, "computer"), camera != null)
    val driver = Driver(seed, plan)
    val odometry = Odometry(drive, gyro)
    val bus = CanBus(Chance(seed, "bus"))
    val console = Console()

    /** The current drawn by lights, fans, radio and computer, in A. */
    val standby = build.between(2.2, 4.5)

    /** The voltage measured by the roboRIO, in V, in steps of 12 mV. */
    var measuredVolts = battery.volts

    /** The total current measured by the power distribution, in A. */
    var totalCurrent = 0.0

    /** Whether the drive gets full power regardless of the sticks. */
    var isPushing = false

    private fun device(
        part: String,
        kind: MotorKind,
        count: Int,
        gear: Double,
        stator: Double,
        supply: Double,
        encoder: Int = 2048,
    ): Device {
        val number = devices.size
        val motor = Motor(part, kind, count, number + 1, CHANNELS[number], gear, stator, supply)
        return Device(motor, Chance(seed, "device $part"), encoder).also { devices += it }
    }

    private fun drive(): Drive {
        val kind = plan.driveKind
        // Sparks and simple controllers limit the stator's current only.
        val hasSupplyLimit = kind != MotorKind.NEO
        val supply = if (hasSupplyLimit) 35.0 else 1000.0
        if (Need.SWERVE in plan.parts) {
            val gear = if (kind == MotorKind.NEO) 6.12 else 6.75
            val stator = if (kind == MotorKind.NEO) 40.0 else 60.0
            val wheels = listOf("FrontLeft", "FrontRight", "BackLeft", "BackRight").mapIndexed { index, name ->
                val steer = { device("$name/Turn", plan.steerKind, 1, 18.75, 30.0, 1000.0) }
                val motor = device("$name/Drive", kind, 1, gear, stator, supply)
                Wheel(name, if (index < 2) 0.29 else -0.29, if (index % 2 == 0) 0.29 else -0.29, motor, steer())
            }
            val top = kind.freeRpm * PI / 30 / gear * 0.0508 * 0.93
            return Drive(true, wheels, build.between(54.0, 66.0), 0.0508, top).placed()
        }
        val gear = if (kind == MotorKind.CIM) 10.71 else 8.45
        val stator = if (kind == MotorKind.CIM) 60.0 else 40.0
        val wheels = listOf("Left", "Right").mapIndexed { index, name ->
            val motor = device("$name/Drive", kind, 2, gear, stator, supply, encoder = 1024)
            Wheel(name, 0.0, if (index == 0) 0.3 else -0.3, motor, null)
        }
        return Drive(false, wheels, build.between(52.0, 66.0), 0.0762, kind.freeRpm * PI / 30 / gear * 0.0762 * 0.93).placed()
    }

    private fun Drive.placed() = apply {
        x = build.between(1.2, 2.2)
        y = build.between(2.0, 6.0)
        heading = if (isSwerve) PI else 0.0
    }

    private val mechanismKind get() = plan.steerKind

    private fun elevator(): Elevator {
        val isSmall = mechanismKind == MotorKind.NEO
        val motor =
            device("Elevator", mechanismKind, 2, if (isSmall) 10.0 else 9.0, if (isSmall) 35.0 else 50.0, if (isSmall) 1000.0 else 30.0)
        return Elevator(motor, build.between(7.0, 11.0), 0.0222, build.between(1.1, 1.6))
    }

    private fun arm(): Arm {
        val isSmall = mechanismKind == MotorKind.NEO
        val motor = device("Arm", mechanismKind, 1, if (isSmall) 90.0 else 75.0, 40.0, if (isSmall) 1000.0 else 30.0)
        return Arm(motor, build.between(0.6, 1.0), build.between(12.0, 19.0), Chance(seed, "arm"))
    }

    private fun shooter(): Shooter {
        val isSmall = mechanismKind == MotorKind.NEO
        return Shooter(
            device("Shooter", mechanismKind, 2, 1.0, if (isSmall) 30.0 else 40.0, if (isSmall) 1000.0 else 25.0),
            build.between(0.0035, 0.006),
        )
    }

    private fun intake() = Intake(device("Intake", mechanismKind, 1, 3.0, 35.0, if (mechanismKind == MotorKind.NEO) 1000.0 else 30.0))

    /** The device of [part]; null if there is none. */
    fun device(part: String): Device? = devices.find { it.motor.part == part }

    /** Advances the physics by [dt] s. */
    fun step(time: Double, dt: Double) {
        val volts = battery.volts
        drive.step(volts, dt)
        elevator?.step(volts, dt)
        arm?.step(volts, dt)
        shooter?.step(volts, dt)
        intake?.step(time, volts, dt)
        var amperes = standby
        var slope = 0.0
        for (device in devices) {
            amperes += device.motor.supply
            slope += device.motor.slope
        }
        air?.let { amperes += it.current }
        battery.take(amperes, slope, dt)
        gyro.step(drive, dt)
    }

    /** The resolution of the power distribution's channels, in A, and of the supply's voltage, in V. */
    val channelStep: Double get() = if (plan.naming == Naming.BADLOG && plan.driveKind == MotorKind.CIM) 0.125 else 0.25

    /** The current of each channel of the power distribution, in A, as measured. */
    val channels = DoubleArray(24)
    private val meter = Chance(seed, "meter")

    /** Updates the measurements of the power distribution and the roboRIO. */
    fun measure() {
        channels.fill(0.0)
        for (device in devices) {
            // Two motors have two channels.
            val each = device.motor.supply.coerceAtLeast(0.0) / device.motor.count
            for (i in 0 until device.motor.count) channels[(device.motor.channel + i) % channels.size] = rounded(each)
        }
        air?.let { channels[COMPRESSOR_CHANNEL] = rounded(it.current) }
        channels[STANDBY_CHANNEL] = rounded(standby)
        totalCurrent = channels.sum()
        measuredVolts = kotlin.math.round((battery.volts + meter.normal(0.012)) / VOLT_STEP) * VOLT_STEP
    }

    private fun rounded(amperes: Double): Double {
        val noise = meter.normal(0.15)
        return if (amperes < 0.2) 0.0 else maxOf(0.0, kotlin.math.round((amperes + noise) / channelStep) * channelStep)
    }

    companion object {
        const val COMPRESSOR_CHANNEL = 22
        const val STANDBY_CHANNEL = 23
        private const val VOLT_STEP = 0.012

        // Every second channel, so that a device with two motors can also use the next one.
        private val CHANNELS = intArrayOf(0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 19)
    }
}

/** The CAN bus, with its utilization and its share of lost frames. */
internal class CanBus(private val chance: Chance) {
    private val usual = chance.between(0.45, 0.66)

    /** The utilization that a fault causes, 0 to 1; 0 for the usual one. */
    var overload = 0.0

    /** The share of lost frames, 0 to 1. */
    var lost = 0.0
    var utilization = usual
        private set

    /** The number of receive errors counted by the roboRIO. */
    var receiveErrors = 0
        private set
    var busOff = 0
        private set

    /** Whether a read in the last loop timed out. */
    var hasTimeout = false
        private set

    fun loop() {
        val target = if (overload > 0) overload else usual
        utilization = (target + chance.normal(0.012)).coerceIn(0.0, 1.0)
        val luck = chance.between(0.0, 1.0)
        hasTimeout = luck < lost * 0.4
        if (luck < lost * 0.5) receiveErrors++
        if (luck < (lost - 0.3) * 0.02) busOff++
    }
}

/** The console of the robot's code. */
internal class Console {
    private val texts = ArrayList<String>()
    private val times = HashMap<String, Double>()

    /** Prints [text], but only one text of a [kind] per second. */
    fun print(time: Double, kind: String, text: () -> String) {
        if (time - (times[kind] ?: -10.0) < 1.0) return
        times[kind] = time
        texts += text()
    }

    /** Removes and returns the texts printed since the last call. */
    fun taken(): List<String> = texts.toList().also { texts.clear() }

    val hasText: Boolean get() = texts.isNotEmpty()
}
