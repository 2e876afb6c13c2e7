package badlog.samples.robot

/**
 * What elevator, arm and rollers do together.
 *
 * @property height where the elevator goes, in metres.
 * @property angle where the arm goes, in degrees.
 * @property rollers the output of the intake's rollers, negative for out.
 */
enum class Superstructure(val height: Double, val angle: Double, val rollers: Double) {
    STOWED(0.0, Arm.STOWED_ANGLE, 0.0),
    INTAKING(0.0, -8.0, 0.85),
    HOLDING(0.12, 70.0, 0.12),
    RAISING(1.36, 35.0, 0.12),
    SCORING(1.36, 12.0, -0.7),
}
