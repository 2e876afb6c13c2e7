package badlog.rules

import badlog.rules.standing.RuleCounts
import badlog.rules.standing.ruleCountsIn
import badlog.rules.standing.trustOf
import org.tomlj.TomlTable
import java.security.MessageDigest

/** The counts of built-in rules, from their table. */
internal val COUNTS: List<RuleCounts> by lazy { ruleCountsIn(resource(COUNTS_FILE)) }

/** Returns the trust in the built-in rule called [name] with the hash [hash] of its text. Counts of another text are not used. */
internal fun countedTrust(name: String, hash: String): Double = trustOf(COUNTS.filter { it.rule == name && it.hash == hash })

/** Returns the first 8 hexadecimal digits of the SHA-256 hash of [rule]. Its comments, and line breaks outside its texts, do not matter. */
internal fun hashOf(rule: TomlTable): String = hashOfJson(rule.toJson())

/** Returns the first 8 hexadecimal digits of the SHA-256 hash of [json], regardless of the system's line ends. */
internal fun hashOfJson(json: String): String =
    MessageDigest.getInstance("SHA-256").digest(json.replace("\r\n", "\n").encodeToByteArray()).take(HASH_BYTES)
        .joinToString("") { "%02x".format(it) }

/** The name of the table of counts, among the resources. */
internal const val COUNTS_FILE = "badlog-counts.tsv"
private const val HASH_BYTES = 4
