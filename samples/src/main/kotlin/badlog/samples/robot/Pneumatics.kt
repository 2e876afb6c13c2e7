package badlog.samples.robot

/** Tanks for the gear shifter and the grabber, and the compressor that fills them again. psi. */
class Pneumatics(pressure: Double) {
    var pressure = pressure
        private set
    var isCompressing = false
        private set
    private var running = 0.0

    fun use(pressureDrop: Double) {
        pressure -= pressureDrop
    }

    fun control(enabled: Boolean, seconds: Double) {
        if (pressure < 90) isCompressing = true
        if (pressure > 118 || !enabled) isCompressing = false
        running = if (isCompressing) running + seconds else 0.0
        pressure -= 0.02 * seconds
        if (isCompressing) pressure += 2.9 * (1 - pressure / 190) * seconds
    }

    /** A compressor works the harder the fuller the tanks are, and starts against them. */
    fun load(load: Load) = when {
        !isCompressing -> load.draw(0.0)
        running < 0.14 -> load.draw(33.0)
        else -> load.draw(8 + pressure / 14)
    }
}
