package badlog.viewer.robot

/**
 * What a robot asks of the person at the window before its logs come.
 *
 * @property text the question.
 * @property isPassword whether the answer is a password; else it is yes or no.
 * @property answer takes it; null for no.
 */
internal class RobotQuestion(val text: String, val isPassword: Boolean, val answer: (String?) -> Unit)

/**
 * A log that comes.
 *
 * @property name what the robot calls it.
 * @property share how much of it is here, from 0 to 1.
 */
internal data class ComingLog(val name: String, val share: Float)

/**
 * The connection to a robot, as the window shows it.
 *
 * @property isShown whether the connection is shown.
 * @property isAsked whether the keyboard is to go to the field of the robot's number as soon as that is there.
 * @property isOn whether the robot is looked for, again and again.
 * @property status how things stand, in a sentence; empty before anything was tried.
 * @property isTrouble whether that hinders logs from coming.
 * @property mayBeEnabled whether logs do not come because nobody knows whether the robot is enabled.
 * @property coming the log that comes now, or null.
 * @property question what the person is asked, or null.
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
    /** Nothing but [status] is known. */
    fun saying(status: String, isTrouble: Boolean = false): RobotLinkState =
        copy(status = status, isTrouble = isTrouble, mayBeEnabled = false, coming = null, question = null)
}
