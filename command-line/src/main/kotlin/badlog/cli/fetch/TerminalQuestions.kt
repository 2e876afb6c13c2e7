package badlog.cli.fetch

import badlog.fetch.FetchQuestions
import badlog.fetch.HostKeyQuestion
import badlog.fetch.RobotAddress
import java.io.Console

/** Asks the person at [terminal]. */
internal class TerminalQuestions(private val terminal: Console) : FetchQuestions {
    override fun trusts(question: HostKeyQuestion): Boolean {
        val what = if (question.isChanged) {
            "The host key of ${question.address} has changed, as when a robot is reimaged or another robot has its address."
        } else {
            "The robot at ${question.address} is unknown."
        }
        terminal.printf("%s\nIts key is %s. Trust it? [y/N] ", what, question.fingerprint)
        return terminal.readLine()?.trim()?.lowercase() in setOf("y", "yes")
    }

    override fun password(user: String, address: RobotAddress): String? =
        terminal.readPassword("Password of %s at %s: ", user, address)?.concatToString()
}
