package badlog.samples.bag

/** How a robot's program writes its numbers. */
enum class NumberText {
    /** As a logger does that was not told otherwise: `%.5g`. */
    FIVE_DIGITS,

    /** With a text function of the team's own: no more decimals than the sensor has. */
    SENSOR_DECIMALS,
}
