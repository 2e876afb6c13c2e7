package badlog.samples.robot

/** Rollers that take in a game piece. A piece stalls them briefly, so that the robot detects it. */
class Intake(private val noise: Noise) {
    private var running = 0.0
    private var stalled = 0.0
    private var amps = 0.0
    var hasPiece = true
        private set

    fun control(rollers: Double, meetsPiece: Boolean, enabled: Boolean, seconds: Double) {
        val output = if (enabled) rollers else 0.0
        running = if (output == 0.0) 0.0 else running + seconds
        if (meetsPiece && output > 0.5 && !hasPiece) {
            hasPiece = true
            stalled = 0.45
        }
        if (output < 0 && running > 0.35) hasPiece = false
        stalled -= seconds
        val inrush = if (output != 0.0 && running < 0.12) 17.0 else 0.0
        val free = StrictMath.abs(output) * (7.5 + noise.around(0.7))
        val wanted = if (stalled > 0 && output != 0.0) 31 + noise.around(1.5) else free + inrush
        amps += (wanted - amps) * 0.6
        if (output == 0.0) amps = 0.0
    }

    fun load(load: Load) = load.draw(amps)
}
