package badlog.samples.generated.robot

/** Tanks of air, a compressor with a pressure switch, and cylinders that use the air up. */
internal class Air(private val chance: Chance, startPressure: Double) {
    /** The pressure in the tanks, in psi. */
    var pressure = startPressure
        private set

    /** The leak at 110 psi, in psi/s. */
    var leak = 0.02

    /** Whether the compressor's circuit is intact. */
    var hasCompressor = true
    private var isWanted = startPressure < 95

    /** Whether the pneumatics module switches the compressor on. */
    var isOn = false
        private set

    /** The current of the compressor, in A. */
    var current = 0.0
        private set
    private var onSeconds = 0.0

    /** The pressure as an analog sensor measures it, in psi. */
    var measured = startPressure
        private set

    /** Moves a cylinder. */
    fun use() {
        pressure = (pressure - 4.5 * pressure / 110).coerceAtLeast(0.0)
    }

    fun step(isEnabled: Boolean, bus: Double, dt: Double) {
        if (pressure < 95) isWanted = true
        if (pressure > 115) isWanted = false
        isOn = isEnabled && isWanted
        val runs = isOn && hasCompressor && bus > 7
        onSeconds = if (runs) onSeconds + dt else 0.0
        current = if (runs) (7 + 0.045 * pressure) * bus / 12 + 14 * kotlin.math.exp(-onSeconds / 0.12) else 0.0
        if (runs) pressure += dt * 4.2 * (1 - pressure / 170) * bus / 12
        pressure -= dt * leak * pressure / 110
    }

    fun updateSensor() {
        measured = kotlin.math.round((pressure + chance.normal(0.35)) * 4) / 4
    }
}
