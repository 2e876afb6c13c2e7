package badlog.samples.generated.robot

/** The robot's code for the mechanisms. Its setpoints follow the driver's errands. */
internal class Mechanisms(private val robot: Robot) {
    private val chance = Chance(robot.plan.seed, "mechanisms")
    private val levels = robot.driver.errands.map { chance.of(listOf(0.45, 0.7, 0.9)) }
    private val poses = robot.driver.errands.map { chance.between(0.3, 0.8) }
    private var last: Errand? = null
    private var shotsDone = 0
    private var pieceDone = false

    /** Updates the setpoints for [time], in s after the start of autonomous. */
    fun plan(time: Double) {
        val driver = robot.driver
        val errand = driver.errand
        if (errand !== last) begin(errand)
        val index = driver.errands.indexOf(errand)
        val rest = errand.until - time
        robot.elevator?.profile?.goal = if (errand.action == Action.SCORE && rest > 0.5) levels[index] * (robot.elevator.height) else 0.0
        robot.arm?.profile?.goal = when {
            errand.action == Action.SCORE -> poses[index]
            errand.action == Action.INTAKE || (errand.action == Action.TRAVEL && rest < 0.6 && isTowardPiece(errand)) -> -0.15
            else -> 1.4
        }
        val isSoon = errand.action == Action.TRAVEL && rest < 2.0 && !isTowardPiece(errand)
        robot.shooter?.setpoint = if (isSoon || errand.action == Action.SCORE) SHOOTER_RPM else IDLE_RPM
        robot.intake?.control(errand.action == Action.INTAKE)
        handlePiecesAndShots(time, errand, rest)
    }

    private fun isTowardPiece(errand: Errand) = errand.x < 5

    private fun begin(errand: Errand) {
        if (last != null && (errand.action == Action.INTAKE || last?.action == Action.INTAKE || errand.action == Action.SCORE)) {
            robot.air?.use()
        }
        last = errand
        shotsDone = 0
        pieceDone = false
    }

    private fun handlePiecesAndShots(time: Double, errand: Errand, rest: Double) {
        val intake = robot.intake
        if (intake != null && errand.action == Action.INTAKE && !pieceDone && time - robot.driver.errandStart > 0.5) {
            pieceDone = true
            intake.isJammed = false
            intake.pieceUntil = time + 0.35
        }
        if (intake != null) {
            intake.hasPiece = (pieceDone && time > intake.pieceUntil) || (errand.action == Action.TRAVEL && !isTowardPiece(errand))
        }
        val shooter = robot.shooter ?: return
        if (errand.action == Action.SCORE && shotsDone < 2 && rest < 0.9 - shotsDone * 0.45) {
            shotsDone++
            shooter.shoot()
        }
    }

    companion object {
        const val SHOOTER_RPM = 4000.0
        private const val IDLE_RPM = 900.0
    }
}
