package badlog.samples.generated.robot

/** A roller that pulls game pieces in. */
internal class Intake(val device: Device) {
    private val motor = device.motor

    /** The time until which a piece is between the rollers, in s; [isJammed] if it is stuck there. */
    var pieceUntil = -1.0
    var isJammed = false

    /** Whether the beam in it is broken by a piece. */
    var hasPiece = false

    fun step(time: Double, bus: Double, dt: Double) {
        val load = if (time < pieceUntil) (if (isJammed) 8.0 else 0.25) else 0.02
        motor.turn(bus, 3.0e-4, 0.0, load, dt)
    }

    fun control(isOn: Boolean) {
        motor.command = if (isOn) 9.0 else 0.0
    }
}
