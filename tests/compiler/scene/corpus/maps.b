surface { texture { map "corpus_has_no_such_file.png" scale 2 } }
