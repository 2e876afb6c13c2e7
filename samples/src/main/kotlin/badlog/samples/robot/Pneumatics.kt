package badlog.samples.robot

/** Tanks for the gear shifter and the grabber, and the compressor that refills them. Pressures are in psi. */
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

    /** Adds the compressor's current, which rises with the pressure in the tanks and is higher at its start. */
    fun load(load: Load) = when {
        !isCompressing -> load.draw(0.0)
        running < 0.14 -> load.draw(33.0)
        else -> load.draw(8 + pressure / 14)
    }
}
