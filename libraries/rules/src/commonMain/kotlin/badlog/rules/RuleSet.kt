package badlog.report.rules

import badlog.report.hook.HookRunner
import java.nio.file.Path

/**
 * Rules to run over logs, and the aliases they use. `docs/rules.md` has the format of the file.
 *
 * @property rules in the order of the file.
 * @property hooks the programs that the file names. They are to be run only where the person who starts badlog named the
 *   file: one that lay among the logs came with them.
 * @property source the file it was read from.
 */
public class RuleSet internal constructor(
    internal val aliases: List<Alias>,
    public val rules: List<Rule>,
    public val hooks: List<HookRunner>,
    public val source: String,
) {
    public companion object {
        /**
         * Reads a file of rules, in TOML.
         *
         * The expressions are checked when they meet a log, because what is a name depends on it.
         *
         * @param folder where its hooks run, usually that of the file; null for where this program runs.
         * @throws RulesException when it is not one.
         */
        public fun parse(text: String, folder: Path? = null): RuleSet = RulesReader(text.removePrefix(BYTE_ORDER_MARK), folder).read()

        /** No rules. */
        public val NONE: RuleSet = RuleSet(emptyList(), emptyList(), emptyList(), "")

        /** The rules that badlog brings along. */
        public val DEFAULT: RuleSet by lazy {
            val stream = checkNotNull(RuleSet::class.java.getResourceAsStream("/badlog/report/badlog-rules.toml"))
            parse(stream.use { it.readBytes().decodeToString() })
        }

        /** What some editors of Windows begin a file with. */
        private const val BYTE_ORDER_MARK = "\uFEFF"
    }
}
