package badlog.catalog.examine

import badlog.catalog.store.BatterySerializer
import badlog.catalog.store.FindingSerializer
import badlog.catalog.store.RepeatedText
import badlog.rules.Finding
import badlog.rules.number.LogNumbers
import badlog.rules.number.LogNumbersReader
import badlog.rules.number.LogNumbersText
import badlog.signals.battery.BatteryUse
import badlog.signals.match.MatchOfLog
import kotlinx.serialization.Serializable

/**
 * The stored results of rules for one log.
 *
 * @property title the title of the match; null if it is unknown, or the file cannot be read.
 * @property findings the findings, in the order of the rules.
 * @property asked the outcome of each rule.
 * @property unreadable why the file cannot be read or is not a log, as a sentence; null if it could be read.
 * @property isNoLog whether it is [unreadable] because it is something other than a log.
 * @property isSalvaged whether data of the log is lost.
 * @property undefined the virtual topics that could not be calculated.
 * @property matchType the type of the match, such as `Qualification`; null if it is unknown.
 * @property numberNames the names of its numbers, see [badlog.rules.number.LogNumbersText].
 * @property numberValues their values, likewise.
 * @property numberDistributions the distributions of some signals, likewise.
 * @property event the event; null if it is unknown.
 * @property matchNumber the number of the match; null if it is unknown.
 * @property began the local time at which it began, according to the log or its file's name, in s since 1970; null if unknown.
 * @property battery its data about the robot's battery; null if it has none.
 */
@Serializable
class ExaminedLog(
    val title: String?,
    val findings: List<
        @Serializable(with = FindingSerializer::class)
        Finding,
        >,
    val asked: List<RuleOutcome>,
    val unreadable: String?,
    val isNoLog: Boolean = false,
    val isSalvaged: Boolean = false,
    val undefined: List<UndefinedTopic> = emptyList(),
    val matchType: String? = null,
    @Serializable(with = RepeatedText::class)
    val numberNames: String = "",
    val numberValues: String = "",
    val numberDistributions: String = "",
    val event: String? = null,
    val matchNumber: String? = null,
    val began: Long? = null,
    @Serializable(with = BatterySerializer::class)
    val battery: BatteryUse? = null,
) {
    /** Its match, without the alliance. */
    val match: MatchOfLog get() = MatchOfLog(event, matchType, matchNumber)

    /** Returns its numbers, read by [reader]. */
    fun numbers(reader: LogNumbersReader): LogNumbers = reader.read(LogNumbersText(numberNames, numberValues, numberDistributions))
}

/**
 * The outcome of [rule] for a log. The other properties are null if the rule ran.
 *
 * @property refusal the reason for skipping it.
 * @property mistake the mistake with its place in the file of rules, if the rule itself seems to be wrong; otherwise null.
 * @property lacking the signal that is missing in the log; null for another reason.
 * @property simulated why the log is considered simulated, if that is the reason; otherwise null.
 */
@Serializable
data class RuleOutcome(
    @Serializable(with = RepeatedText::class) val rule: String,
    @Serializable(with = RepeatedText::class) val refusal: String? = null,
    @Serializable(with = RepeatedText::class) val mistake: String? = null,
    @Serializable(with = RepeatedText::class) val lacking: String? = null,
    @Serializable(with = RepeatedText::class) val simulated: String? = null,
)
