package badlog.report.cache

import kotlinx.serialization.KSerializer

/**
 * Of a value that is the same for many: [CompactWriter] writes equal ones once, and [CompactReader] gives one object for all of them.
 *
 * @param whole how such a value is written.
 */
internal open class Shared<T>(val whole: KSerializer<T>) : KSerializer<T> by whole
