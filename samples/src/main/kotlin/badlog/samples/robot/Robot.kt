package badlog.samples.robot

/** The whole robot, simulated in loops of 20 ms. */
class Robot(seed: Long, val battery: Battery, val drivetrain: Drivetrain, pressure: Double, private val mishaps: Mishaps) {
    private val noise = Noise(seed)
    val power = PowerDistribution(noise)
    val roboRio = RoboRio(noise)
    val elevator = Elevator()
    val arm = Arm()
    val intake = Intake(noise)
    val pneumatics = Pneumatics(pressure)
    val camera = Camera(noise)
    val gyro = Gyro(noise)
    val sensors = Sensors(this, noise)

    var mode = Mode.DISABLED
        private set
    var state = Superstructure.STOWED
        private set
    private var stateSeconds = 0.0

    val isPowered get() = mode != Mode.DISABLED && !roboRio.isBrownedOut

    /** Runs the robot's program at the start of a loop: reads its sensors, then sets its outputs. */
    fun control(time: Double, seconds: Double, mode: Mode, sticks: Sticks) {
        this.mode = mode
        val canIsCut = mishaps.canIsCut(time)
        roboRio.checkBrownout(battery.volts, seconds)
        roboRio.work(mode != Mode.DISABLED, mishaps.stallSeconds(time), mishaps.canIsSilent(time) || canIsCut, canIsCut)
        if (!canIsCut) power.measure(battery.volts)
        camera.look(drivetrain, seconds, mishaps.stallSeconds(time))
        if (mishaps.isHitAt(time, seconds)) {
            drivetrain.hit()
            gyro.restart()
            sensors.loseEncoder(Side.LEFT)
        }
        gyro.measure(drivetrain, seconds)
        battery.contactOhms = mishaps.contactOhms(time)
        drivetrain.isDriven = !canIsCut
        drivetrain.unplugged = mishaps.unpluggedSides(time)
        drivetrain.seized = mishaps.seizedGearbox(time)
        elevator.isDriven = !canIsCut
        elevator.isHalf = mishaps.elevatorIsHalf(time)
        elevator.isSeized = mishaps.elevatorIsSeized(time)
        mishaps.blindSides(time).forEach(sensors::loseEncoder)
        drive(sticks)
        moveSuperstructure(sticks, seconds)
        pneumatics.control(isPowered, seconds)
        if (!canIsCut) sensors.measure(isElevatorSilent = mishaps.canIsSilent(time), seconds)
    }

    private fun drive(sticks: Sticks) {
        if (isPowered && sticks.highGear != drivetrain.isHighGear) {
            drivetrain.isHighGear = sticks.highGear
            pneumatics.use(SHIFT)
        }
        drivetrain.leftOutput = if (isPowered) (sticks.throttle - sticks.turn).coerceIn(-1.0, 1.0) else 0.0
        drivetrain.rightOutput = if (isPowered) (sticks.throttle + sticks.turn).coerceIn(-1.0, 1.0) else 0.0
        drivetrain.obstacle = sticks.obstacle
    }

    private fun moveSuperstructure(sticks: Sticks, seconds: Double) {
        stateSeconds += seconds
        if (isPowered && sticks.state != state) {
            state = sticks.state
            stateSeconds = 0.0
            if (state == Superstructure.INTAKING || state == Superstructure.SCORING) pneumatics.use(GRAB)
        }
        elevator.control(isPowered, seconds)
        if (isPowered) elevator.profile.goal = state.height
        arm.control(state.angle, isPowered, seconds)
        intake.control(state.rollers, stateSeconds > sticks.pieceAfter, isPowered, seconds)
    }

    /** Advances the simulation by [seconds] with unchanged outputs. */
    fun pass(seconds: Double) {
        val step = seconds / STEPS
        repeat(STEPS) {
            power.load()
            drivetrain.load(power.leftDrive, power.rightDrive, battery.volts)
            elevator.load(power.elevator, battery.volts)
            arm.load(power.arm)
            intake.load(power.intake)
            pneumatics.load(power.compressor)
            battery.supply(power.channels, step)
            drivetrain.move(battery.volts, step)
            elevator.move(battery.volts, step)
            arm.move(step)
        }
    }
}

/**
 * A combined state of elevator, arm and rollers.
 *
 * @property height the goal of the elevator, in m.
 * @property angle the goal of the arm, in degrees.
 * @property rollers the output of the intake's rollers, negative for out.
 */
enum class Superstructure(val height: Double, val angle: Double, val rollers: Double) {
    STOWED(0.0, Arm.STOWED_ANGLE, 0.0),
    INTAKING(0.0, -8.0, 0.85),
    HOLDING(0.12, 70.0, 0.12),
    RAISING(1.36, 35.0, 0.12),
    SCORING(1.36, 12.0, -0.7),
}

// The elevator's stiff motors need steps shorter than a loop.
private const val STEPS = 5

// The pressure that a move of the shifter or the grabber costs, in psi.
private const val SHIFT = 0.9
private const val GRAB = 1.6
