package badlog.viewer.session.link

import badlog.rules.Finding
import badlog.viewer.text.addressText
import badlog.viewer.text.nameOfAddress

/**
 * The name that distinguishes a finding from others that begin at the same moment.
 *
 * @property rule the name of the rule or the hook that found it.
 * @property topic the topic of the finding; null if there is none.
 */
class FindingName(val rule: String, val topic: String?) {
    /** Returns whether this is the name of [finding]. */
    fun isOf(finding: Finding): Boolean = finding.rule == rule && finding.topic == topic

    /** Returns the name for an address: `Brownout;PDP/Voltage`. */
    internal fun toText(): String = listOfNotNull(rule, topic).joinToString(";", transform = ::addressText)

    companion object {
        /** Returns the name of [finding]. */
        fun of(finding: Finding): FindingName = FindingName(finding.rule, finding.topic)
    }
}

/** Returns the name that [FindingName.toText] wrote as [text]; null for any other text. */
internal fun findingNameOf(text: String): FindingName? {
    val names = text.split(';').map { nameOfAddress(it) ?: return null }
    return if (names.size > 2) null else FindingName(names[0], names.getOrNull(1))
}
