package badlog.catalog.store

import kotlinx.serialization.KSerializer

/**
 * The serializer of a value that many share: [CompactWriter] writes equal ones once, and [CompactReader] returns one object for all
 * of them.
 *
 * @param whole the serializer of such a value.
 */
open class Shared<T>(val whole: KSerializer<T>) : KSerializer<T> by whole
