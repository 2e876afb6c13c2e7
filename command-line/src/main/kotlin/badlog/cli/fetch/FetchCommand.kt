package badlog.cli.fetch

import badlog.cli.command.SubCommand
import badlog.cli.command.Task
import badlog.fetch.FetchOptions
import badlog.fetch.RobotAddress
import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.help
import com.github.ajalt.clikt.parameters.options.convert
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.path
import java.nio.file.Path
import java.time.Duration

internal class FetchCommand(private val robots: Robots) :
    SubCommand(
        "fetch",
        "Copies new logs from a robot, while it is disabled.",
        "“badlog fetch 1014” looks for the robot of that team and copies new logs to the folder logs; with " +
            "--watch it continues until Ctrl+C. Interrupted copies are resumed next time. docs/fetch.md has more examples.",
    ) {
    private val robot by argument("ROBOT").help("A team's number, or an address, such as 10.10.14.2 or me@robot.local.")
    private val out by option("-o", "--out", metavar = "FOLDER").path().default(Path.of("logs"))
        .help("Put logs here; default: logs.")
    private val isWatching by option("--watch").flag().help("Keep copying new logs until Ctrl+C.")
    private val folders by option("--from", metavar = "FOLDER").multiple()
        .help("The robot's folder; default: ~/logs and /u/logs.")
    private val limit by option("--limit", metavar = "RATE").convert { rateOf(it) ?: fail("“$it” is not a rate; use one such as 2MB/s") }
        .help("Copy no faster than this, such as 2MB/s.")
    private val age by option("--delete-older-than", metavar = "AGE")
        .convert { ageOf(it) ?: fail("“$it” is not an age; use one such as 14d or 36h") }
        .help("Remove logs this old (14d, 36h) from the robot.")
    private val user by option("--user", metavar = "NAME").help("User name; default: lvuser, then systemcore.")
    private val anyway by option("--anyway").flag().help("Copy even if the robot may be enabled.")
    private val acceptsNewHostKeys by option("--accept-new-host-key").flag().help("Trust a robot that is unknown or has a new key.")

    override val examples: List<String> = listOf(
        "fetch 1014",
        "fetch 10.10.14.2 --out match-logs --watch",
        "fetch 1014 --delete-older-than 14d",
    )

    override val words: List<String> get() = listOf(robot)

    override fun makeTask(): Task {
        val options = FetchOptions(out, folders.ifEmpty { null }, anyway, limit, age, acceptsNewHostKeys, robots.password)
        return FetchTask(addresses(), options, robots, isWatching, isJson)
    }

    private fun addresses(): List<RobotAddress> = try {
        robots.addressesOf(robot, user)
    } catch (e: IllegalArgumentException) {
        throw UsageError(e.message.orEmpty())
    }
}

/** Returns the bytes per second in [text], such as `2MB/s`, `500k` or `1000000`; null for anything else. */
internal fun rateOf(text: String): Long? {
    val (number, unit) = RATE.matchEntire(text.trim())?.destructured ?: return null
    val factor = when (unit.lowercase()) {
        "k" -> 1e3
        "m" -> 1e6
        "g" -> 1e9
        else -> 1.0
    }
    return (number.toDouble() * factor).toLong().takeIf { it > 0 }
}

/** Returns the age in [text], such as `14d` or `36h`; null for anything else. */
internal fun ageOf(text: String): Duration? {
    val (number, unit) = AGE.matchEntire(text.trim())?.destructured ?: return null
    return if (unit == "d") Duration.ofDays(number.toLong()) else Duration.ofHours(number.toLong())
}

private val RATE = Regex("(\\d{1,9}(?:\\.\\d{1,6})?) ?([kMG]?)(?:B)?(?:/s)?", RegexOption.IGNORE_CASE)
private val AGE = Regex("(\\d{1,5}) ?([dh])")
