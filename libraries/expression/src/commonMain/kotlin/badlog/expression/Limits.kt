package badlog.expression

/**
 * What an expression may be at most. They keep what comes from elsewhere from overflowing the stack, and bound the work: each
 * node costs a pass over the samples, and only what moves times makes more of them.
 */
internal object Limits {
    const val LENGTH = 4000
    const val NESTING = 100
    const val DEPTH = 200
    const val NODES = 500
    const val MOVES = 16
}
