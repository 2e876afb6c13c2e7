package badlog.window.robot

/**
 * A question to the person at the window before logs can be fetched.
 *
 * @property text the question.
 * @property isPassword whether the answer is a password; otherwise it is yes or no.
 * @property answer receives the answer; null for no.
 */
internal class RobotQuestion(val text: String, val isPassword: Boolean, val answer: (String?) -> Unit)

/**
 * A log being copied.
 *
 * @property name its name on the robot.
 * @property share the copied fraction, 0 to 1.
 */
internal data class ComingLog(val name: String, val share: Float)

/**
 * The connection to a robot, as the window shows it.
 *
 * @property isShown whether the connection is shown.
 * @property isAsked whether the field of the robot's number gets the keyboard focus as soon as it is visible.
 * @property isOn whether the window repeatedly looks for the robot.
 * @property status the status, as a sentence; empty before the first attempt.
 * @property isTrouble whether the status prevents fetching.
 * @property mayBeEnabled whether fetching waits because it is unknown whether the robot is enabled.
 * @property coming the log being copied, or null.
 * @property question the question to the person, or null.
 */
internal data class RobotLinkState(
    val isShown: Boolean = false,
    val isAsked: Boolean = false,
    val isOn: Boolean = false,
    val status: String = "",
    val isTrouble: Boolean = false,
    val mayBeEnabled: Boolean = false,
    val coming: ComingLog? = null,
    val question: RobotQuestion? = null,
) {
    /** Shows the connection, with the keyboard focus in the field of the robot's number. */
    fun shown(): RobotLinkState = copy(isShown = true, isAsked = true)

    /** Shows the connection, or hides it. */
    fun toggled(): RobotLinkState = if (isShown) copy(isShown = false, isAsked = false) else shown()

    /** Returns the state with only a new [status]. */
    fun saying(status: String, isTrouble: Boolean = false): RobotLinkState =
        copy(status = status, isTrouble = isTrouble, mayBeEnabled = false, coming = null, question = null)
}
