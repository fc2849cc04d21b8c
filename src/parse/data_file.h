/* Data files: what #fopen names. glim writes none: what a scene writes is kept
 * while it is being read, so that it can read it back or include it. */
#ifndef PARSE_DATA_FILE_H
#define PARSE_DATA_FILE_H

#include "parse/parser.h"

struct data_text; /* what was written under one name */

/* An open file: what its identifier stands for. */
struct data_file {
    const char *name;
    const struct token_list *list; /* being read; NULL: being written */
    size_t next;                   /* token to read */
    struct data_text *text;        /* being written */
};

/* Opens what the scene has written under that name or, if it has not, the file
 * on disk. NULL after an error was reported at `span`. */
struct data_file *data_file_read(struct parser *p, const char *name,
                                 struct span span);
/* Opens for writing, at the end of what there is if `append`. */
struct data_file *data_file_write(struct parser *p, const char *name,
                                  bool append, struct span span);

/* The next value and the comma behind it; not at the end. False after an error
 * was reported in the file. */
bool data_file_next(struct parser *p, struct data_file *file,
                    struct value *value);
/* Whether nothing is left to read. */
bool data_file_ends(const struct data_file *file);

/* Numbers and strings as POV-Ray writes them. */
void data_file_put(struct parser *p, struct data_file *file,
                   const struct value *value);
/* Bytes that are no text were written: they are not kept. */
void data_file_put_bytes(struct data_file *file);

/* Warns of what the scene has written and not read back: it is lost. */
void data_files_tell(struct parser *p);

/* What the scene wrote under the name, as a source that `span` asks for; NULL
 * if it wrote nothing. *problem is why it can't be read back, or NULL. */
const struct source *data_file_written(struct parser *p, const char *name,
                                       struct span span, const char **problem);

#endif
