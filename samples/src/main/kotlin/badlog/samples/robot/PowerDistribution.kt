package badlog.samples.robot

/** The power distribution panel, with the mechanisms on its 16 channels and their measured currents. */
class PowerDistribution(private val noise: Noise) {
    val channels: List<Load> = List(16) { Load() }
    val leftDrive: List<Load> = channels.slice(0..1)
    val rightDrive: List<Load> = channels.slice(14..15)
    val elevator: List<Load> = listOf(channels[2], channels[13])
    val arm: Load = channels[3]
    val intake: Load = channels[12]
    val compressor: Load = channels[11]
    private val camera: Load = channels[8]
    private val radio: Load = channels[9]
    private val measured = DoubleArray(16)

    val total: Double get() = measured.sum()

    fun measuredAmps(channel: Int): Double = measured[channel]

    fun load() {
        camera.draw(1.4)
        radio.draw(0.9)
    }

    /** Measures in steps of an eighth of an ampere; returned current counts as 0. */
    fun measure(volts: Double) {
        for (i in channels.indices) {
            val amps = channels[i].amps(volts)
            val reading = if (amps == 0.0) 0.0 else amps + noise.around(0.12 + amps * 0.012)
            measured[i] = Math.floor(maxOf(0.0, reading) * 8 + 0.5) / 8
        }
    }
}
